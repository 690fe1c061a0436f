// SPDX-License-Identifier: MIT
#include "runtime/playback/root_motion.h"

#include <algorithm>
#include <cmath>

#include "runtime/math/swing_twist.h"

namespace sinew {
namespace {

using Vec3d = Vec3<double>;
using Quatd = Quat<double>;

Quatd turn_of(const Quatd& turn, RootTurn kind) noexcept {
  if (kind == RootTurn::none) return quat_identity<double>();
  if (kind == RootTurn::full) return turn;
  const HalfTwistT<double> half = half_twist(turn, Vec3d(0.0, 1.0, 0.0));
  return normalised(quat_xyzw(0.0, half.sine, 0.0, half.cosine));
}

/// eq   m^count by repeated squaring; a negative count is the power of the inverse
DualQuatd power(DualQuatd m, double count) noexcept {
  constexpr double kMostTurns = 9.0e15;
  if (count < 0.0) m = dual_quat_conjugate(m);
  DualQuatd result;
  for (auto left = static_cast<std::uint64_t>(std::min(std::fabs(count), kMostTurns)); left > 0; left /= 2) {
    if (left % 2 != 0) result = normalised(result * m);
    m = normalised(m * m);
  }
  return result;
}

/// Clip time of a phase. In ping-pong, phases above the duration run from the end to the start.
double clip_time_s(const PlaybackStep& step, double phase_s) noexcept {
  return phase_s <= step.duration_s ? phase_s : 2.0 * step.duration_s - phase_s;
}

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
  const auto place = [&](double time_s) { return root_place(root, rest, parts, time_s); };
  const DualQuatd back = dual_quat_conjugate(place(clip_time_s(step, step.from_s)));
  const DualQuatd to = place(clip_time_s(step, step.to_s));
  if (step.mode != PlayMode::loop || step.to_turns == step.from_turns) return normalised(back * to);
  const DualQuatd round = place(step.duration_s) * dual_quat_conjugate(place(0.0));
  return normalised(back * power(round, step.to_turns - step.from_turns) * to);
}

DualQuatd mirrored_motion(const DualQuatd& motion, const Vec3<double>& plane_normal) noexcept {
  const Quatd normal = quat_xyzw(plane_normal.x, plane_normal.y, plane_normal.z, 0.0);
  const Vec3d along = translation_of(motion);
  return dual_quat_from(normal * motion.real * quat_conjugate(normal),
                        along - plane_normal * (2.0 * glm::dot(plane_normal, along)));
}

}  // namespace sinew
