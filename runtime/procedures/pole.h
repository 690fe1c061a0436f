// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdint>

#include "runtime/math/axis_angle.h"
#include "runtime/math/two_bones.h"

namespace sinew {

/// How the direction in which a limb bends is given.
enum class PoleKind : std::uint8_t {
  none,       ///< the limb stays in the plane in which the input pose bends it
  direction,  ///< a direction in model space
  point,      ///< a place in model space; the direction runs from the first joint to it
  tip_axis,   ///< a direction in the space of the limb's tip, for example where the foot points
};

/// Sine of the angle between pole and target below which the pole fades. A target that crosses the line of the pole
/// then turns the limb smoothly instead of snapping it.
inline constexpr float kPoleFade = 0.25f;

namespace ik {

/// Unit direction perpendicular to the unit vector `along`, towards the pole. It blends to `kept` as the pole becomes
/// parallel to `along`, and is `kept` if the pole is zero.
/// eq   normalise(p + kept fade (1 - |p| / fade)^2), p = the part of the unit pole perpendicular to `along`
///      No rule is continuous for all directions of a target (hairy ball theorem). This rule jumps at one point near
///      the pole and at one near its opposite, where p and kept are opposite and cancel.
inline Vec3<double> pole_side(const Vec3<double>& along, const Vec3<double>& pole, const Vec3<double>& kept,
                              double fade) noexcept {
  if (pole == Vec3<double>(0.0)) return kept;
  const Vec3<double> unit = normalised_or(pole, Vec3<double>(0.0));
  return two_bones::blended_side(unit - along * glm::dot(unit, along), kept, fade);
}

/// The component of `v` perpendicular to the unit vector `along`, scaled to length 1; `fallback` if it is zero.
inline Vec3<double> unit_beside(const Vec3<double>& v, const Vec3<double>& along,
                                const Vec3<double>& fallback) noexcept {
  return normalised_or(v - along * glm::dot(v, along), fallback);
}

/// Axes of an object that aims: `along` (x) points to its target, `side` (y) is perpendicular to it.
struct Frame {
  Vec3<double> along, side;  ///< unit and perpendicular
  Mat3<double> matrix() const noexcept { return {along, side, glm::cross(along, side)}; }
};

/// How a frame rolls about the line to its target.
struct Roll {
  Vec3<double> pole{0.0};  ///< direction to which y rolls; zero: y follows the shortest turn
  double fade = 0.0;
  double share = 1.0;  ///< share of pole and twist that is applied
  double twist_rad = 0.0;
};

/// The frame after the shortest turn to a target, followed by a roll. If the target is zero, x stays.
inline Frame aimed_frame(const Frame& now, const Vec3<double>& target, const Roll& roll) noexcept {
  Frame aimed{normalised_or(target, now.along), now.side};
  const Vec3<double> carried = rotate_vector(rotation_between(now.along, aimed.along), now.side);
  const Vec3<double> kept = unit_beside(carried, aimed.along, now.side);
  const Vec3<double> asked = pole_side(aimed.along, roll.pole, kept, roll.fade);
  aimed.side = roll.share == 1.0 ? asked : kept + (asked - kept) * roll.share;
  if (roll.twist_rad != 0.0)
    aimed.side = rotate_vector(quat_from_axis_angle(aimed.along, roll.share * roll.twist_rad), aimed.side);
  aimed.side = unit_beside(aimed.side, aimed.along, kept);
  return aimed;
}

/// Unit quaternion of a turn by an angle about a unit axis.
/// in   cosine, sine  of the angle, with any common factor >= 0
/// eq   half angles by square roots. Divides by the larger of sine and cosine, so that no digits are lost
inline Quat<double> turn_about(const Vec3<double>& axis, double cosine, double sine) noexcept {
  const double length = std::sqrt(cosine * cosine + sine * sine);
  if (!(length > 0.0)) return quat_identity<double>();
  const double c = cosine / length, s = sine / length;
  if (c >= 0.0) {
    const double w = std::sqrt((1.0 + c) / 2.0), v = s / (2.0 * w);
    return quat_xyzw(axis.x * v, axis.y * v, axis.z * v, w);
  }
  const double v = std::sqrt((1.0 - c) / 2.0);
  return quat_xyzw(axis.x * v, axis.y * v, axis.z * v, s / (2.0 * v));
}

}  // namespace ik
}  // namespace sinew
