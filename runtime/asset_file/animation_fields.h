// SPDX-License-Identifier: MIT
// The fields of clips in authoring form; see asset_fields.h.
#pragma once
#include "runtime/asset_file/asset_fields.h"

namespace sinew {

template <class T>
concept IsTrack = Is<T, Vec3Track> || Is<T, QuatTrack>;

auto fields(IsTrack auto& t) {
  auto& [interpolation, times_s, values] = t;
  return std::tie(interpolation, times_s, values);
}

auto fields(Is<WeightTrack> auto& t) {
  auto& [interpolation, times_s, values, target_count] = t;
  return std::tie(interpolation, times_s, values, target_count);
}

auto fields(Is<BoneAnimation> auto& b) {
  auto& [joint, translation, rotation, scale] = b;
  return std::tie(joint, translation, rotation, scale);
}

auto fields(Is<WeightAnimation> auto& a) {
  auto& [instance, weights, first_target] = a;
  return std::tie(instance, weights, first_target);
}

auto fields(Is<PropertyTrack> auto& t) {
  auto& [target, values] = t;
  return std::tie(target, values);
}

auto fields(Is<Animation> auto& a) {
  auto& [name, duration_s, bones, weights, properties] = a;
  return std::tie(name, duration_s, bones, weights, properties);
}

}  // namespace sinew
