// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/animation/keyframe.h"
#include "runtime/animation/property_track.h"
#include "runtime/animation/track.h"

namespace sinew {

/// The animation of one joint in authoring form: plain, readable, and the *truth* that compiled clips are held to.
/// Translation, rotation and scale have their own key times, as in glTF; a missing track leaves the rest value.
class BoneAnimation {
 public:
  std::uint32_t joint = 0;
  Vec3Track translation;
  QuatTrack rotation;
  Vec3Track scale;

  /// A BoneAnimation from whole keys, with one interpolation for all three tracks (cubic_spline is refused: whole keys
  /// carry no tangents).
  /// err  unsupported, and everything that check(Track) answers
  static Result<BoneAnimation> from_keyframes(std::uint32_t joint, std::span<const Keyframe> keys,
                                              Interpolation interpolation = Interpolation::linear);

  bool empty() const noexcept { return translation.empty() && rotation.empty() && scale.empty(); }

  /// First and last key time over the three tracks, 0 without any key.
  double start_time() const noexcept;
  double end_time() const noexcept;

  /// Local transform at `time_s`; each track clamps to its own first and last key (G10), and returns stored key values
  /// bit-exact at key times (G06). `rest` supplies the properties that have no track.
  /// eq   glTF 2.0, Appendix C: step, slerp / linear, Hermite with tangents scaled by the key interval; squad by
  ///      Shoemake 1987.   T is the precision of the arithmetic: double is the truth.   cost O(log K)
  template <class T>
  TransformT<T> interpolate(double time_s, const TransformT<T>& rest = {}) const noexcept;
};

template <>
TransformT<float> BoneAnimation::interpolate(double time_s, const TransformT<float>& rest) const noexcept;
template <>
TransformT<double> BoneAnimation::interpolate(double time_s, const TransformT<double>& rest) const noexcept;

/// Morph weights of one mesh instance over time: all of them, or `weights.target_count` from `first_target` on.
struct WeightAnimation {
  std::uint32_t instance = 0;  ///< index into Scene::instances
  WeightTrack weights;
  std::uint32_t first_target = 0;
};

/// One animation of the file in authoring form. `duration_s` is the largest last key time over all tracks; the
/// animation always starts at 0 (G11).
struct Animation {
  std::string name;
  double duration_s = 0.0;
  std::vector<BoneAnimation> bones;
  std::vector<WeightAnimation> weights;
  std::vector<PropertyTrack> properties = {};  ///< one per target
};

}  // namespace sinew
