// SPDX-License-Identifier: MIT
#include "runtime/animation/bone_animation.h"

#include <algorithm>

#include "runtime/animation/track_sample.h"

namespace sinew {

Result<BoneAnimation> BoneAnimation::from_keyframes(std::uint32_t joint, std::span<const Keyframe> keys,
                                                    Interpolation interpolation) {
  if (interpolation == Interpolation::cubic_spline) return tl::unexpected(ErrorCode::unsupported);
  BoneAnimation bone;
  bone.joint = joint;
  bone.rotation.interpolation = interpolation;
  // Squad exists for rotations only. Translation and scale become linear.
  const bool step = interpolation == Interpolation::step;
  bone.translation.interpolation = bone.scale.interpolation = step ? Interpolation::step : Interpolation::linear;
  for (const Keyframe& key : keys) {
    bone.rotation.times_s.push_back(static_cast<float>(key.time_s));
    bone.translation.values.push_back(key.translation);
    bone.rotation.values.push_back(key.rotation);
    bone.scale.values.push_back(key.scale);
  }
  bone.translation.times_s = bone.scale.times_s = bone.rotation.times_s;
  for (const ErrorCode code : {check(bone.translation), check(bone.rotation), check(bone.scale)})
    if (code != ErrorCode::ok) return tl::unexpected(code);
  return bone;
}

double BoneAnimation::start_time() const noexcept {
  double start = 0.0;
  bool found = false;
  for (const auto* times : {&translation.times_s, &rotation.times_s, &scale.times_s}) {
    if (times->empty()) continue;
    const double first = static_cast<double>(times->front());
    start = found ? std::min(start, first) : first;
    found = true;
  }
  return start;
}

double BoneAnimation::end_time() const noexcept {
  double end = 0.0;
  for (const auto* times : {&translation.times_s, &rotation.times_s, &scale.times_s})
    if (!times->empty()) end = std::max(end, static_cast<double>(times->back()));
  return end;
}

namespace {

template <class T>
TransformT<T> interpolate_tracks(const BoneAnimation& bone, double time_s, const TransformT<T>& rest) noexcept {
  TransformT<T> out = rest;
  if (!bone.translation.empty()) out.translation = sample_track<T>(bone.translation, time_s);
  if (!bone.rotation.empty()) out.rotation = sample_track<T>(bone.rotation, time_s);
  if (!bone.scale.empty()) out.scale = sample_track<T>(bone.scale, time_s);
  return out;
}

}  // namespace

template <>
TransformT<float> BoneAnimation::interpolate(double time_s, const TransformT<float>& rest) const noexcept {
  return interpolate_tracks(*this, time_s, rest);
}

template <>
TransformT<double> BoneAnimation::interpolate(double time_s, const TransformT<double>& rest) const noexcept {
  return interpolate_tracks(*this, time_s, rest);
}

}  // namespace sinew
