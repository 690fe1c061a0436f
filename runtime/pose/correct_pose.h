// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/run_job.h"
#include "runtime/model/pose_corrective.h"
#include "runtime/pose/pose.h"

namespace sinew {

/// Pose-space corrective: adds its interpolated corrections to the morph weights that it drives.
/// eq   weights[i] += f(pose), f the interpolant of the corrective; with `clamp` f stays in the range of the samples.
///      With `partition` the shares s of the samples are clamped to [0, 1] and divided by their sum, f = sum(s *
///      values). Far from all samples, where the shares sum to less than 0.01, f fades out with the square of the
///      sum. At a sample pose (q or -q) a corrective without regularisation adds exactly the values of the sample: a
///      neutral pose of zeros changes nothing. Results below 1e-20 are zero (N26).
/// in   pose       local rotations, of any length but zero;   scratch[scratch_size(*corrective)]
/// out  weights    the scene's flat array of morph weights
/// err  size_mismatch, index_out_of_range. Computed in double, to 1e-6 of the largest value.
/// cost O(samples * (drivers + morph weights)), no allocation
struct CorrectPoseJob {
  const PoseCorrective* corrective = nullptr;
  PoseSpan pose;
  std::span<double> scratch;
  std::span<float> weights;
};

/// Doubles that `scratch` must have room for.
std::size_t scratch_size(const PoseCorrective& corrective) noexcept;

ErrorCode check(const CorrectPoseJob& job) noexcept;
void run_unchecked(const CorrectPoseJob& job) noexcept;

}  // namespace sinew
