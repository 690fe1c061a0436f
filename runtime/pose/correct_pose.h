// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/model/pose_corrective.h"
#include "runtime/pose/pose.h"

namespace sinew {

/// Adds what a corrective makes of a pose to the morph weights that it drives.
/// eq   weights[i] += f(pose), f the corrective's interpolant, with `clamp` kept in the range of the samples' values.
///      With `partition` its shares s are cut to [0, 1] and divided by their sum, and f = sum(s * values); far from all
///      samples, where they sum to less than 0.01, f fades out with the square of the sum instead of blowing up.
///      At a sample pose, q or -q, an unregularised corrective adds the sample's values, bit for bit: a neutral pose of
///      zeros morphs nothing. Results below 1e-20 are zero (N26).
/// in   pose       local rotations, of any length but zero;   scratch[scratch_size(*corrective)]
/// out  weights    the scene's flat array of morph weights
/// err  size_mismatch, index_out_of_range; all of it in double, its error below 1e-6 of the largest value
/// cost O(samples * (drivers + morph weights)), no allocation
struct CorrectPoseJob {
  const PoseCorrective* corrective = nullptr;
  PoseSpan pose;
  std::span<double> scratch;
  std::span<float> weights;
};

/// Numbers that the job keeps while it runs.
std::size_t scratch_size(const PoseCorrective& corrective) noexcept;

ErrorCode check(const CorrectPoseJob& job) noexcept;
void run(const CorrectPoseJob& job) noexcept;

}  // namespace sinew
