// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>

#include "runtime/math/axis_angle.h"
#include "runtime/math/perpendicular.h"
#include "runtime/math/rotation_between.h"

namespace sinew {

/// Places of the joints of a limb: hip, knee and ankle of a leg, for example.
template <class T>
struct TwoBonesT {
  Vec3<T> root{T(0)}, middle{T(0)}, tip{T(0)};
};

/// How the two bones turn: rotations in the space of the places, to be applied after those that the bones have.
template <class T>
struct TwoBoneTurnsT {
  Quat<T> upper = quat_identity<T>(), lower = quat_identity<T>();
};

/// Share of a limb's length over which it slows down before it is straight. 0 turns that off.
inline constexpr double kSoftReach = 0.01;

/// Distance from the root up to which the tip reaches a goal exactly. A limb that is straighter already keeps its
/// length.
template <class T>
T free_reach(const TwoBonesT<T>& limb, T soft_reach = T(kSoftReach)) noexcept {
  const T straight = safe_length(limb.middle - limb.root) + safe_length(limb.tip - limb.middle);
  return (std::max)((T(1) - soft_reach) * straight, safe_length(limb.tip - limb.root));
}

namespace two_bones {

/// Distance of the tip from the root for a wanted one. Up to `free` they are equal. Beyond it the distance approaches
/// the straight limb exponentially and never gets there, so that the middle joint slows down.
template <class T>
T reached(T wanted, T free, T upper, T lower) noexcept {
  const T rest = upper + lower - free;
  if (wanted > free) wanted = rest > T(0) ? free + rest * (T(1) - std::exp((free - wanted) / rest)) : free;
  return (std::max)(wanted, std::abs(upper - lower));
}

/// Unit direction in which the middle joint lies off the line from root to tip. Where it is nearer to the line than 2 %
/// of the limb's length, its own direction is mostly rounding noise, and `bend` takes over.
template <class T>
Vec3<T> bend_direction(const Vec3<T>& along, const Vec3<T>& to_middle, const Vec3<T>& bend, T length) noexcept {
  constexpr T kStraight = T(0.02);
  const Vec3<T> off = (to_middle - along * glm::dot(to_middle, along)) / length;
  const Vec3<T> wanted = normalised_or(bend - along * glm::dot(bend, along), perpendicular_to(along));
  const T share = (std::max)(T(0), T(1) - safe_length(off) / kStraight);
  return normalised_or(off + wanted * (kStraight * share * share), wanted);
}

}  // namespace two_bones

/// Turns two bones so that their tip comes to a place, in the plane in which they are bent.
/// eq   With bones of lengths a, b and the tip at distance d of the root, the middle joint is x along the line to the
///      tip and y beside it. With r = (a - b) / d, Heron's formula gives
///      x = ((a + b) r + d) / 2,   y = sqrt((a + b + d) (a + b - d) (1 + r) (1 - r)) / 2.
///      No difference of squares occurs, so digits last where the limb is nearly straight or folded.
/// in   bend        direction of the middle joint where the limb is straight, of any length
///      goal        a goal out of reach is approached; the distance stays below a + b (two_bones::reached)
///      soft_reach  share of the length over which the limb slows down; 0 reaches every goal up to a + b exactly
/// out  identities within rounding where the tip is at the goal; identities for bones without length
template <class T>
TwoBoneTurnsT<T> turn_two_bones(const TwoBonesT<T>& limb, const Vec3<T>& goal, const Vec3<T>& bend,
                                T soft_reach = T(kSoftReach)) noexcept {
  const Vec3<T> upper = limb.middle - limb.root, lower = limb.tip - limb.middle, whole = limb.tip - limb.root;
  const T a = safe_length(upper), b = safe_length(lower), now = safe_length(whole);
  if (!(a > T(0)) || !(b > T(0)) || !(now > T(0))) return {};
  const Vec3<T> along = whole / now, to_goal = goal - limb.root;
  const T d = two_bones::reached(safe_length(to_goal), free_reach(limb, soft_reach), a, b);
  // Equal bones fold onto the root: d is 0 there, and the middle joint stands beside it.
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
