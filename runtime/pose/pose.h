// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>

#include "runtime/math/transform.h"

namespace sinew {

/// View of the local transforms of J joints as structure of arrays: ten planes (translation xyz, rotation xyzw, scale
/// xyz) of `stride` floats each. `stride` is J rounded up to a multiple of 16, so that vectors may reach past the
/// last joint. Planes start on 64-byte boundaries. Owns nothing.
struct PoseSpan {
  enum Plane : std::size_t { tx, ty, tz, rx, ry, rz, rw, sx, sy, sz, plane_count };

  float* planes = nullptr;
  std::size_t joint_count = 0;
  std::size_t stride = 0;

  static constexpr std::size_t stride_for(std::size_t joint_count) noexcept { return (joint_count + 15) / 16 * 16; }
  /// Floats that a buffer of `joint_count` joints takes.
  static constexpr std::size_t floats_for(std::size_t joint_count) noexcept {
    return plane_count * stride_for(joint_count);
  }

  float* plane(Plane p) const noexcept { return planes + static_cast<std::size_t>(p) * stride; }

  Transform get(std::size_t j) const noexcept {
    const auto at = [&](Plane p) { return plane(p)[j]; };
    return {{at(tx), at(ty), at(tz)}, quat_xyzw(at(rx), at(ry), at(rz), at(rw)), {at(sx), at(sy), at(sz)}};
  }
  void set(std::size_t j, const Transform& t) const noexcept {
    plane(tx)[j] = t.translation.x;
    plane(ty)[j] = t.translation.y;
    plane(tz)[j] = t.translation.z;
    set_rotation(j, t.rotation);
    plane(sx)[j] = t.scale.x;
    plane(sy)[j] = t.scale.y;
    plane(sz)[j] = t.scale.z;
  }
  void set_rotation(std::size_t j, const glm::quat& rotation) const noexcept {
    plane(rx)[j] = rotation.x;
    plane(ry)[j] = rotation.y;
    plane(rz)[j] = rotation.z;
    plane(rw)[j] = rotation.w;
  }
};

/// True if `pose` is a usable view of `joint_count` joints: it has memory and the stride of that count.
inline bool is_pose_of(const PoseSpan& pose, std::size_t joint_count) noexcept {
  return pose.joint_count == joint_count && pose.stride == PoseSpan::stride_for(joint_count) &&
         (joint_count == 0 || pose.planes != nullptr);
}

/// A view over `memory`, which must be 64-byte aligned and hold PoseSpan::floats_for(joint_count) floats.
inline PoseSpan pose_over(std::span<float> memory, std::size_t joint_count) noexcept {
  return {memory.data(), joint_count, PoseSpan::stride_for(joint_count)};
}

}  // namespace sinew
