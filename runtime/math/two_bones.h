// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>

#include "runtime/math/axis_angle.h"
#include "runtime/math/rotation_between.h"

namespace sinew {

/// Positions of the joints of a limb, for example hip, knee and ankle of a leg.
template <class T>
struct TwoBonesT {
  Vec3<T> root{T(0)}, middle{T(0)}, tip{T(0)};
};

/// Rotations of the two bones in the space of the positions, to be applied after the current rotations of the bones.
template <class T>
struct TwoBoneTurnsT {
  Quat<T> upper = quat_identity<T>(), lower = quat_identity<T>();
};

/// The last part of the reach, as a share of the limb's length, in which the limb straightens more and more slowly. 0
/// turns this off.
inline constexpr double kSoftReach = 0.01;

/// Distance from the root up to which the tip reaches a goal exactly. It is at least the current distance of the tip.
template <class T>
T free_reach(const TwoBonesT<T>& limb, T soft_reach = T(kSoftReach)) noexcept {
  const T straight = safe_length(limb.middle - limb.root) + safe_length(limb.tip - limb.middle);
  return (std::max)((T(1) - soft_reach) * straight, safe_length(limb.tip - limb.root));
}

namespace two_bones {

/// Distance from the root at which the tip is placed, for a wanted distance. Up to `free` both are equal. Beyond, the
/// result approaches upper + lower exponentially, so the middle joint does not snap when the limb straightens.
template <class T>
T softened_distance(T wanted, T free, T upper, T lower) noexcept {
  const T rest = upper + lower - free;
  if (wanted > free) wanted = rest > T(0) ? free + rest * (T(1) - std::exp((free - wanted) / rest)) : free;
  return (std::max)(wanted, std::abs(upper - lower));
}

/// Unit direction from the line between root and tip to the middle joint. It blends to `bend` where the middle joint
/// is closer to the line than 2 % of the limb's length, since there the direction is mostly noise.
template <class T>
Vec3<T> bend_direction(const Vec3<T>& along, const Vec3<T>& to_middle, const Vec3<T>& bend, T length) noexcept {
  constexpr T kStraight = T(0.02);
  const Vec3<T> off = (to_middle - along * glm::dot(to_middle, along)) / length;
  const Vec3<T> wanted = normalised_or(bend - along * glm::dot(bend, along), perpendicular_to(along));
  const T share = (std::max)(T(0), T(1) - safe_length(off) / kStraight);
  return normalised_or(off + wanted * (kStraight * share * share), wanted);
}

}  // namespace two_bones

/// Two-bone inverse kinematics: turns both bones so that the tip reaches a goal, in the plane in which the limb is
/// bent.
/// eq   With bones of lengths a, b and the tip at distance d of the root, the middle joint is x along the line to the
///      tip and y beside it. With r = (a - b) / d, Heron's formula gives
///      x = ((a + b) r + d) / 2,   y = sqrt((a + b + d) (a + b - d) (1 + r) (1 - r)) / 2.
///      This has no difference of squares, so no digits are lost where the limb is nearly straight or folded.
/// in   bend        direction in which the middle joint goes if the limb is straight, of any length
///      goal        if it is out of reach, the tip stops before it, at less than a + b (two_bones::softened_distance)
///      soft_reach  as kSoftReach; with 0 the tip reaches every goal up to a + b exactly
/// out  identities within rounding if the tip is at the goal; identities if a bone has no length
template <class T>
TwoBoneTurnsT<T> turn_two_bones(const TwoBonesT<T>& limb, const Vec3<T>& goal, const Vec3<T>& bend,
                                T soft_reach = T(kSoftReach)) noexcept {
  const Vec3<T> upper = limb.middle - limb.root, lower = limb.tip - limb.middle, whole = limb.tip - limb.root;
  const T a = safe_length(upper), b = safe_length(lower), now = safe_length(whole);
  if (!(a > T(0)) || !(b > T(0)) || !(now > T(0))) return {};
  const Vec3<T> along = whole / now, to_goal = goal - limb.root;
  const T d = two_bones::softened_distance(safe_length(to_goal), free_reach(limb, soft_reach), a, b);
  // If equal bones fold completely, d is 0, and the middle joint goes straight to the side.
  const T r = d > T(0) ? std::clamp((a - b) / d, T(-1), T(1)) : T(0);
  const Quat<T> turn = rotation_between(along, to_goal);
  const Vec3<T> axis = rotate_vector(turn, glm::cross(along, two_bones::bend_direction(along, upper, bend, a + b)));
  const T x = ((a + b) * r + d) / T(2);
  const T y = std::sqrt((a + b + d) * (std::max)(T(0), a + b - d) * (T(1) + r) * (T(1) - r)) / T(2);
  const auto turned = [&](const Vec3<T>& bone, T angle) {
    return normalised(quat_from_axis_angle(axis, angle) * turn * rotation_between(bone, along));
  };
  return {turned(upper, std::atan2(y, x)), turned(lower, -std::atan2(y, d - x))};
}

}  // namespace sinew
