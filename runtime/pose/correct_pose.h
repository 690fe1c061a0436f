// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/model/pose_corrective.h"
#include "runtime/pose/pose.h"

namespace sinew {

/// Pose-space corrective: adds interpolated corrections to the morph weights that the corrective drives.
/// eq   weights[i] += f(pose), where f interpolates the samples of the corrective
///      With `clamp`, f stays within the range of the sample values.
///      With `partition`, the shares s of the samples are clamped to [0, 1] and divided by their sum: f = sum(s *
///      values).
///      Far from all samples, where the shares sum to less than 0.01, f fades out with the square of the sum.
///      At a sample pose (q or -q) a corrective without regularisation adds exactly the values of that sample.
///      A neutral sample of zeros therefore changes nothing. Results below 1e-20 become zero: denormals are slow.
/// in   pose       local rotations of any length but zero;   scratch[scratch_size(*corrective)]
/// out  weights    the scene's flat array of morph weights
/// err  size_mismatch, index_out_of_range. Computed in double, accurate to 1e-6 of the largest value.
/// cost O(samples * (drivers + morph weights)), no allocation
struct CorrectPoseJob {
  const PoseCorrective* corrective = nullptr;
  PoseSpan pose;
  std::span<double> scratch;
  std::span<float> weights;
};

/// Number of doubles that CorrectPoseJob::scratch needs.
SINEW_API std::size_t scratch_size(const PoseCorrective& corrective) noexcept;

SINEW_API ErrorCode check(const CorrectPoseJob& job) noexcept;
SINEW_API void run_unchecked(const CorrectPoseJob& job) noexcept;

}  // namespace sinew
