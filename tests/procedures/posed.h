// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/math/affine.h"
#include "tests/support/near.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {

/// A skeleton with a pose of its own, evaluated in double.
struct Posed {
  Skeleton skeleton;
  PoseBuffer pose;

  explicit Posed(Skeleton s) : skeleton(std::move(s)), pose(skeleton.joint_count()) {}

  Transform get(std::uint32_t j) { return pose.span().get(j); }
  void set(std::uint32_t j, const Transform& t) { pose.span().set(j, t); }
  /// Makes the pose the rest pose, too.
  void rest() {
    for (std::uint32_t j = 0; j < skeleton.joint_count(); ++j) skeleton.rest[j] = get(j);
  }
  Affined model(std::uint32_t j) {
    if (j == kNone) return {};
    const Transform t = get(j);
    const Transformd local{Vec3<double>(t.translation), normalised(quat_cast<double>(t.rotation)),
                           Vec3<double>(t.scale)};
    return model(skeleton.parents[j]) * affine_from_transform(local);
  }
  Vec3<double> place(std::uint32_t j) { return translation_of(model(j)); }
  Quat<double> rotation(std::uint32_t j) {
    if (j == kNone) return quat_identity<double>();
    return normalised(rotation(skeleton.parents[j]) * quat_cast<double>(get(j).rotation));
  }
  std::vector<float> bits() {
    const float* const planes = pose.span().planes;
    return {planes, planes + PoseSpan::floats_for(skeleton.joint_count())};
  }
};

/// Largest turn of any joint between two poses, in degrees.
inline double largest_turn_deg(const PoseSpan& a, const PoseSpan& b) {
  double most = 0.0;
  for (std::size_t j = 0; j < a.joint_count; ++j)
    most = std::max(most, angle_between(a.get(j).rotation, b.get(j).rotation));
  return glm::degrees(most);
}

inline double angle_of(const Vec3<double>& a, const Vec3<double>& b) {
  return std::atan2(safe_length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace sinew::test
