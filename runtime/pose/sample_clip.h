// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/clip/clip.h"
#include "runtime/pose/pose.h"

namespace sinew {

/// Samples a clip at one time: the local pose of every joint, all morph weights and all animated properties. Joints,
/// weights and properties that the clip does not animate get their rest values. Each track clamps to its own first and
/// last key.
/// eq   as BoneAnimation::interpolate, in float
/// in   time_s         seconds in the clip
///      holds_clip     `pose` already holds a sample of this clip, so joints that the clip does not animate are not
///      written again
/// out  pose           of the clip's joint count;   weights[W]  of the clip's weight count; empty = not wanted
///      properties[P]  of the clip's property count; empty = not wanted
/// err  size_mismatch        cost O(groups * log K + animated tracks), no allocation
struct SampleClipJob {
  const Clip* clip = nullptr;
  double time_s = 0.0;
  PoseSpan pose;
  std::span<float> weights;
  std::span<float> properties = {};
  bool holds_clip = false;
};

SINEW_API ErrorCode check(const SampleClipJob& job) noexcept;
SINEW_API void run_unchecked(const SampleClipJob& job) noexcept;

}  // namespace sinew
