// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/animation/annotations.h"
#include "runtime/animation/property_track.h"
#include "runtime/animation/track.h"
#include "runtime/base/api.h"
#include "runtime/math/transform.h"

namespace sinew {

/// One whole key of a joint: its transform in its parent's space at a time.
template <class T>
struct KeyframeT {
  double time_s = 0.0;
  Vec3<T> translation{T(0)};
  Quat<T> rotation{T(1), T(0), T(0), T(0)};  // w x y z
  Vec3<T> scale{T(1)};
};

using Keyframe = KeyframeT<float>;

/// The animation of one joint in authoring form, as plain tracks. It is the *truth*: the exact motion that compiled
/// clips are compared with. Translation, rotation and scale have their own key times, as in glTF. A property without a
/// track keeps its rest value.
class SINEW_API BoneAnimation {
 public:
  std::uint32_t joint = 0;
  Vec3Track translation;
  QuatTrack rotation;
  Vec3Track scale;

  /// A BoneAnimation from whole keys, with one interpolation for all three tracks. cubic_spline is refused, since
  /// whole keys have no tangents.
  /// err  unsupported (cubic_spline), and those of check(Track)
  static Result<BoneAnimation> from_keyframes(std::uint32_t joint, std::span<const Keyframe> keys,
                                              Interpolation interpolation = Interpolation::linear);

  bool empty() const noexcept { return translation.empty() && rotation.empty() && scale.empty(); }

  /// First and last key time of the three tracks, in seconds; 0 without keys.
  double start_time() const noexcept;
  double end_time() const noexcept;

  /// Local transform at `time_s`. Each track clamps to its own first and last key, and returns the stored bits at key
  /// times. Properties without a track come from `rest`.
  /// eq   glTF 2.0, Appendix C: step, slerp / linear, Hermite with tangents scaled by the key interval; squad by
  ///      Shoemake 1987.   T is the precision of the arithmetic: double is the truth.   cost O(log K)
  template <class T>
  TransformT<T> interpolate(double time_s, const TransformT<T>& rest = {}) const noexcept;
};

template <>
SINEW_API TransformT<float> BoneAnimation::interpolate(double time_s, const TransformT<float>& rest) const noexcept;
template <>
SINEW_API TransformT<double> BoneAnimation::interpolate(double time_s, const TransformT<double>& rest) const noexcept;

/// The morph weights of one mesh instance over time. The track animates `weights.target_count` morph targets, beginning
/// with `first_target`. Most tracks animate all targets of the mesh.
struct WeightAnimation {
  std::uint32_t instance = 0;  ///< index into Scene::instances
  WeightTrack weights;
  std::uint32_t first_target = 0;
};

/// One animation of the file in authoring form. It always starts at time 0; `duration_s` is the largest key time of
/// all tracks.
struct Animation {
  std::string name;
  double duration_s = 0.0;
  std::vector<BoneAnimation> bones;
  std::vector<WeightAnimation> weights;
  std::vector<PropertyTrack> properties = {};  ///< at most one per PropertyTarget
  Annotations annotations = {};                ///< events and curves; they do not lengthen the clip
};

}  // namespace sinew
