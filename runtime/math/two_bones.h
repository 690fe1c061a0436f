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

/// Distance for a wanted one. Up to `free` it is the wanted one. Beyond, it approaches `straight` exponentially, so the
/// middle joint does not snap when the limb straightens.
template <class T>
T soft_stop(T wanted, T free, T straight) noexcept {
  const T rest = straight - free;
  if (wanted <= free) return wanted;
  return rest > T(0) ? free + rest * (T(1) - std::exp((free - wanted) / rest)) : free;
}

/// Distance of the tip from the root for a wanted distance: soft_stop before upper + lower, and at least
/// |upper - lower|.
template <class T>
T softened_distance(T wanted, T free, T upper, T lower) noexcept {
  return (std::max)(soft_stop(wanted, free, upper + lower), std::abs(upper - lower));
}

/// Unit direction of `off`, which is at most 1 long. It blends to unit `wanted` where `off` is shorter than `fade`,
/// since there its direction is mostly noise. It has no limit only where both cancel out.
template <class T>
Vec3<T> blended_side(const Vec3<T>& off, const Vec3<T>& wanted, T fade) noexcept {
  const T share = fade > T(0) ? (std::max)(T(0), T(1) - safe_length(off) / fade) : T(0);
  return normalised_or(off + wanted * (fade * share * share), wanted);
}

/// Share of the limb's length below which the middle joint counts as lying on the line between root and tip.
inline constexpr double kStraight = 0.02;

/// Unit direction from the line between root and tip to the middle joint. It blends to `bend` where the middle joint
/// is closer to the line than kStraight.
template <class T>
Vec3<T> bend_direction(const Vec3<T>& along, const Vec3<T>& to_middle, const Vec3<T>& bend, T length) noexcept {
  const Vec3<T> off = (to_middle - along * glm::dot(to_middle, along)) / length;
  const Vec3<T> wanted = normalised_or(bend - along * glm::dot(bend, along), perpendicular_to(along));
  return blended_side(off, wanted, T(kStraight));
}

/// Place of the middle joint: x along the line from root to tip, y >= 0 beside it.
template <class T>
struct CornerT {
  T x = T(0), y = T(0);
};

/// Corner of a triangle with bones of lengths a, b and the tip at distance d of the root, |a - b| <= d <= a + b.
/// eq   With r = (a - b) / d, Heron's formula gives
///      x = ((a + b) r + d) / 2,   y = sqrt((a + b + d) (a + b - d) (1 + r) (1 - r)) / 2.
///      This has no difference of squares, so no digits are lost where the limb is nearly straight or folded.
template <class T>
CornerT<T> corner(T a, T b, T d) noexcept {
  // If equal bones fold completely, d is 0, and the middle joint goes straight to the side.
  const T r = d > T(0) ? std::clamp((a - b) / d, T(-1), T(1)) : T(0);
  return {((a + b) * r + d) / T(2),
          std::sqrt((a + b + d) * (std::max)(T(0), a + b - d) * (T(1) + r) * (T(1) - r)) / T(2)};
}

}  // namespace two_bones

/// Two-bone inverse kinematics: turns both bones so that the tip reaches a goal, in the plane in which the limb is
/// bent.
/// eq   the angles of the triangle of both bones (two_bones::corner)
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
  const two_bones::CornerT<T> place = two_bones::corner(a, b, d);
  const Quat<T> turn = rotation_between(along, to_goal);
  const Vec3<T> axis = rotate_vector(turn, glm::cross(along, two_bones::bend_direction(along, upper, bend, a + b)));
  const auto turned = [&](const Vec3<T>& bone, T angle) {
    return normalised(quat_from_axis_angle(axis, angle) * turn * rotation_between(bone, along));
  };
  return {turned(upper, std::atan2(place.y, place.x)), turned(lower, -std::atan2(place.y, d - place.x))};
}

}  // namespace sinew
