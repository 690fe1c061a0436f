// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/compress/truth_samples.h"

namespace sinew {

/// How far a compiled clip is from its authoring form.
struct ClipError {
  std::vector<double> of_joint_m;  ///< [J] largest error of the joint's virtual vertices in model space
  double weights_m = 0.0;          ///< largest displacement of vertices by wrong morph weights of one instance
  double worst_m = 0.0;            ///< largest sum of both at one time
  double worst_time_s = 0.0;
  std::uint32_t worst_joint = kNone;
  std::uint64_t truth_poses = 0;  ///< of the truth that were evaluated for this, where no sample was kept
};

/// Every key time of every track of joints and weights, and both ends of the clip; rising, each once.
std::vector<float> key_times(const Animation& truth);

/// Every key time of every track, both ends of the clip, five times between each two, and the time right before each
/// jump (of steps, and of keys that share a time). A clip with more than kMostJointTimes poses of joints in that list
/// is looked at in even steps through it.
std::vector<double> times_to_check(const Animation& truth, std::size_t joint_count);
inline constexpr std::size_t kMostJointTimes = 10'000'000;

/// Samples a clip as a frame does, in float, and compares it in double with BoneAnimation::interpolate. The hierarchy
/// is evaluated in double on both sides, so that only the clip's own error counts. Of several forms of a clip each
/// error is the largest.
/// eq   of_joint[j] = max |M'[j] c - M[j] c| over the times of `truth` and corners c
///      weights = max sum |w' - w| metres_per_weight stretch
/// in   forms  of the clip, compiled for this scene
/// cost O(times x J x forms), allocates
ClipError measure_clip(const TruthSamples& truth, std::span<const Clip* const> forms);

}  // namespace sinew
