// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/run_job.h"
#include "runtime/clip/clip.h"
#include "runtime/pose/pose.h"

namespace sinew {

/// Local pose of every joint, all morph weights and all animated properties at one time of a clip. What the clip does
/// not animate gets its rest value (G22). Times outside the clip clamp per track (G10).
/// eq   as BoneAnimation::interpolate, in float
/// in   time_s         seconds in the clip
///      holds_clip     `pose` holds a sample of this clip already: joints that it does not animate are not written
///      (P01)
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

ErrorCode check(const SampleClipJob& job) noexcept;
void run_unchecked(const SampleClipJob& job) noexcept;

}  // namespace sinew
