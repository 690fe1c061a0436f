// SPDX-License-Identifier: MIT
#include "runtime/playback/root_motion.h"

#include <cmath>

#include "runtime/math/swing_twist.h"
#include "runtime/playback/carried_motion.h"

namespace sinew {
namespace {

using Vec3d = Vec3<double>;
using Quatd = Quat<double>;

/// eq   y of turn = Ry(y) Rz(z) Rx(x): y = atan2(-a.z, a.x), a the rotated +X
Quatd euler_heading(const Quatd& turn) noexcept {
  const Vec3d a = rotate_vector(turn, Vec3d(1.0, 0.0, 0.0));
  const double level = std::hypot(a.x, a.z);
  constexpr double kVertical = 1e-9;  // x is then noise, and the turns about +Y and about +X cannot be told apart
  if (level < kVertical) return normalised(quat_xyzw(0.0, a.y > 0.0 ? turn.x : -turn.x, 0.0, turn.w));
  if (a.x < 0.0 && a.z == 0.0) return quat_xyzw(0.0, 1.0, 0.0, 0.0);
  return normalised(quat_xyzw(0.0, -a.z, 0.0, level + a.x));  // half the angle
}

Quatd turn_of(const Quatd& turn, RootTurn kind) noexcept {
  if (kind == RootTurn::none) return quat_identity<double>();
  if (kind == RootTurn::full) return turn;
  if (kind == RootTurn::heading_euler) return euler_heading(turn);
  const HalfTwistT<double> half = half_twist(turn, Vec3d(0.0, 1.0, 0.0));
  return normalised(quat_xyzw(0.0, half.sine, 0.0, half.cosine));
}

/// Weighted mean of rigid motions as poses are blended: translations linearly, rotations as quaternions of one
/// hemisphere.
class RigidMean {
 public:
  void add(const DualQuatd& motion, double weight) noexcept {
    translation_ += translation_of(motion) * weight;
    rotation_ = rotation_ + aligned_with(rotation_, motion.real) * weight;
    weight_ += weight;
  }
  DualQuatd mean() const noexcept {
    if (!(weight_ > 0.0) || !(safe_length(rotation_) > 0.0)) return {};
    return dual_quat_from(normalised(rotation_), translation_ / weight_);
  }

 private:
  Vec3d translation_{0.0};
  Quatd rotation_ = quat_xyzw(0.0, 0.0, 0.0, 0.0);
  double weight_ = 0.0;
};

}  // namespace

DualQuatd root_place(const BoneAnimation& root, const Transform& rest, const RootMotionParts& parts,
                     double time_s) noexcept {
  const Quatd rest_rotation = normalised(quat_cast<double>(rest.rotation));
  const Transformd local =
      root.interpolate<double>(time_s, {Vec3d(rest.translation), rest_rotation, Vec3d(rest.scale)});
  const Vec3d carried(parts.x ? local.translation.x : 0.0, parts.y ? local.translation.y : 0.0,
                      parts.z ? local.translation.z : 0.0);
  return dual_quat_from(turn_of(normalised(local.rotation) * quat_conjugate(rest_rotation), parts.turn), carried);
}

DualQuatd root_motion(const BoneAnimation& root, const Transform& rest, const RootMotionParts& parts,
                      const PlaybackStep& step) noexcept {
  return carried_motion([&](double time_s) { return root_place(root, rest, parts, time_s); }, step);
}

BlendedRoot blend_root_motion(std::span<const RootShare> shares) noexcept {
  RigidMean motion, place;
  for (const RootShare& share : shares) {
    motion.add(share.motion, share.weight);
    place.add(share.place, share.weight);
  }
  return {motion.mean(), place.mean()};
}

DualQuatd mirrored_motion(const DualQuatd& motion, const Vec3<double>& plane_normal) noexcept {
  const Quatd normal = quat_xyzw(plane_normal.x, plane_normal.y, plane_normal.z, 0.0);
  const Vec3d along = translation_of(motion);
  return dual_quat_from(normal * motion.real * quat_conjugate(normal),
                        along - plane_normal * (2.0 * glm::dot(plane_normal, along)));
}

}  // namespace sinew
