// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/compress/truth_samples.h"

namespace sinew {

/// How far a compiled clip is from its authoring form.
struct ClipError {
  std::vector<double> of_joint_m;  ///< [J] largest error of the joint's virtual vertices in model space
  double weights_m = 0.0;          ///< largest displacement of a vertex caused by wrong morph weights of one instance
  double worst_m = 0.0;            ///< largest sum of joint and weight error at one time
  double worst_time_s = 0.0;
  std::uint32_t worst_joint = kNone;
  /// Number of poses of the authoring form that were evaluated because no sample was kept
  std::uint64_t truth_poses = 0;
};

/// All key times of joint and weight tracks and both ends of the clip; rising, each once.
SINEW_API std::vector<float> key_times(const Animation& truth);

/// Times at which a clip is measured: all key times of all tracks, both ends of the clip and five times between each
/// two. Before each jump (stepped keys, keys that share a time) the last moment is added. If that would be more than
/// kMaxJointTimes joint poses, the list is thinned out evenly.
SINEW_API std::vector<double> times_to_check(const Animation& truth, std::size_t joint_count);
inline constexpr std::size_t kMaxJointTimes = 10'000'000;

/// Samples a clip in float, as a frame does, and compares it in double with BoneAnimation::interpolate. Both
/// hierarchies are evaluated in double, so that only the clip's own error counts.
/// eq   of_joint[j] = max |M'[j] c - M[j] c| over the times of `truth` and the corners c of VirtualVertices::boxes[j];
///      M' and M are model matrices of the clip and of `truth`
///      weights = max sum |w' - w| metres_per_weight stretch
/// in   forms  the same clip in several forms (packed, unpacked), compiled for this scene
/// out  each error is the largest of all forms
/// cost O(times x J x forms), allocates
SINEW_API ClipError measure_clip(const TruthSamples& truth, std::span<const Clip* const> forms);

/// Same, for keys in authoring form, which are evaluated in double. Equal keys have no error.
/// in   written   tracks of the same joints and instances, or fewer
SINEW_API ClipError measure_animation(const TruthSamples& truth, const Animation& written);

/// Measures parts of an animation, for a search that changes it a little again and again.
class SINEW_API PartMeter {
 public:
  /// in   truth  must outlive it
  explicit PartMeter(const TruthSamples& truth);
  ~PartMeter();

  /// True if the error of measure_animation() is within the limit at all times after `begin_s` and before `end_s`.
  /// in   work  the number of joints that were evaluated is added to it
  bool is_within(const Animation& written, double begin_s, double end_s, double limit_m, std::uint64_t& work);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sinew
