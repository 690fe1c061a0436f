// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/model/pose_samples.h"

namespace sinew {

/// Pose-space deformation: an interpolant over sample poses that gives morph weights for any pose. solve_corrective
/// makes it and pose/correct_pose.h evaluates it; it never changes in between.
/// eq   f(pose) = sum over basis functions b of b(pose) * coefficients[b], with f = values at each sample pose
///      (Lewis, Cordner and Fong 2000, "Pose space deformation", section 4)
struct PoseCorrective {
  PoseSamples samples;
  /// [basis_size][R], one row per basis function. R = M: the results are the morph weights. With `partition` R = S:
  /// the results are shares of the samples, and the weights are the mean of the samples' values weighted by them.
  std::vector<double> coefficients;
  std::vector<float> lower, upper;  ///< [M] range of the samples' values

  std::size_t result_count() const noexcept {
    return samples.partition ? samples.sample_count() : samples.weights.size();
  }
};

/// Solves for the coefficients, in double. Without regularisation the interpolant passes through all samples.
/// eq   [K + r I, P; P^T, 0] [c; t] = [values; 0],  K[i][j] = kernel(distance of samples i and j), P the functions of
///      the tail at the samples. Angular distances can make K indefinite, even for kernels that are positive definite
///      in Euclidean space. So it uses LU with full pivoting, and checks the condition number.
/// err  as check(PoseSamples); coincident_poses (two samples less than 1e-6 rad apart, without regularisation);
///      rank_deficient (condition beyond 1e10: too few poses for the tail, or a gaussian far wider than their
///      distances)
/// cost O(basis^3), allocates
Result<PoseCorrective> solve_corrective(PoseSamples samples);

/// Checks sizes, indices and numbers of a solved corrective.
/// in   joint_count, weight_count  of the scene
/// err  as check(PoseSamples), index_out_of_range, unsupported (a range whose lower end is above the upper one)
ErrorCode check(const PoseCorrective& corrective, std::size_t joint_count, std::size_t weight_count) noexcept;

}  // namespace sinew
