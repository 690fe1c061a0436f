// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/assets/clip.h"
#include "runtime/base/result.h"
#include "runtime/jobs/pose.h"

namespace sinew {

/// Local pose of every joint, and all morph weights, at one time of a clip. Joints and weights that the clip does not
/// animate get their rest values (G22). Times outside the clip clamp per track (G10).
/// eq   as BoneAnimation::interpolate, in float
/// in   time_s      seconds in the clip
/// out  pose        of the clip's joint count;   weights[W]  the clip's weight count, may be empty = not wanted
/// err  size_mismatch        cost O(groups * log K + animated tracks), no allocation
struct SampleClipJob {
  const Clip* clip = nullptr;
  double time_s = 0.0;
  PoseSpan pose;
  std::span<float> weights;
};

ErrorCode check(const SampleClipJob& job) noexcept;
void run(const SampleClipJob& job) noexcept;

}  // namespace sinew
