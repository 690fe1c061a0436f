// SPDX-License-Identifier: MIT
#include "runtime/procedures/hinge.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/math/inverse.h"

namespace sinew::ik {
namespace {

using V = Vec3<double>;
using Q = Quat<double>;

/// Bones shorter than this share of the limb's length are treated as having no length.
constexpr double kNoLength = 1e-12;

/// True if m scales evenly, up to the rounding of rotations in float.
bool keeps_angles(const Mat3<double>& m, double& scale) noexcept {
  const double x = glm::dot(m[0], m[0]), y = glm::dot(m[1], m[1]), z = glm::dot(m[2], m[2]);
  const double largest = std::max({x, y, z}), least = std::min({x, y, z});
  const double shear =
      std::max({std::abs(glm::dot(m[0], m[1])), std::abs(glm::dot(m[1], m[2])), std::abs(glm::dot(m[2], m[0]))});
  scale = std::sqrt((x + y + z) / 3.0);
  return largest - least <= 5e-7 * largest && shear <= 5e-7 * largest;
}

/// The lower bone's vector for a bend angle, given by cosine and sine.
V lower_at(const Hinge& hinge, double cosine, double sine) noexcept {
  return (hinge.upper * cosine + glm::cross(hinge.axis, hinge.upper) * sine) * hinge.b + hinge.axis * hinge.lower_along;
}

double distance_at(const Bones& bones, const Hinge& hinge, double bend) noexcept {
  return safe_length(bones.upper + bones.to_root * lower_at(hinge, std::cos(bend), std::sin(bend)));
}

/// The bend in [low, high] with the largest `sign` * distance. Ternary search works, because the distance has a single
/// extremum there.
double extremum(const Bones& bones, const Hinge& hinge, double low, double high, double sign) noexcept {
  for (int i = 0; i < 80; ++i) {
    const double third = (high - low) / 3.0, left = low + third, right = high - third;
    if (sign * distance_at(bones, hinge, left) < sign * distance_at(bones, hinge, right))
      low = left;
    else
      high = right;
  }
  return (low + high) / 2.0;
}

/// Distance from root to tip for a bend, if the bones scale evenly.
double even_distance(const Bones& bones, const Hinge& hinge, double bend) noexcept {
  const auto whole = [&](double across) {
    return bones.scale * std::sqrt(across * across + hinge.along * hinge.along);
  };
  if (bend == 0.0) return whole(hinge.a + hinge.b);
  if (bend >= std::numbers::pi - 1e-6) return whole(hinge.a - hinge.b);
  const double square = hinge.a * hinge.a + hinge.b * hinge.b + 2.0 * hinge.a * hinge.b * std::cos(bend);
  return bones.scale * std::sqrt(std::max(0.0, square) + hinge.along * hinge.along);
}

bool can_bend(const Bones& bones, const Hinge& hinge) noexcept {
  return !bones.is_flat && std::min(hinge.a, hinge.b) > kNoLength * bones.length_here;
}

void measure(const Bones& bones, Hinge& hinge) noexcept {
  const double upper_along = glm::dot(bones.upper_here, hinge.axis);
  const V across = bones.upper_here - hinge.axis * upper_along;
  hinge.a = safe_length(across);
  hinge.upper = hinge.a > 0.0 ? across / hinge.a : perpendicular_to(hinge.axis);
  hinge.along = upper_along + hinge.lower_along;
}

}  // namespace

Bones bones_of(const Mat3<double>& to_root, const V& upper, const V& lower) noexcept {
  Bones bones{to_root, upper, upper, lower};
  if (to_root != Mat3<double>(1.0)) {
    const auto back = inverse_of(affine_from(to_root, V(0.0)));
    bones.is_flat = !back.has_value();
    if (back) bones.upper_here = transform_vector(*back, upper);
    bones.is_even = keeps_angles(to_root, bones.scale);
  }
  bones.length_here = safe_length(bones.upper_here) + safe_length(lower);
  return bones;
}

V bend_axis(const Bones& bones) noexcept {
  return glm::cross(normalised_or(bones.upper_here, V(0.0)), normalised_or(bones.lower, V(0.0)));
}

V axis_towards(const Bones& bones, const V& pole_at_root) noexcept {
  const auto back = inverse_of(affine_from(bones.to_root, V(0.0)));
  return back ? glm::cross(transform_vector(*back, pole_at_root), bones.upper_here) : V(0.0);
}

Hinge fixed_hinge(const Bones& bones, const V& axis) noexcept {
  Hinge hinge;
  hinge.axis = normalised_or(axis, V(0, 0, 1));
  hinge.lower_along = glm::dot(bones.lower, hinge.axis);
  measure(bones, hinge);
  const V across = bones.lower - hinge.axis * hinge.lower_along;
  hinge.b = safe_length(across);
  hinge.cosine = glm::dot(hinge.upper, across);
  hinge.sine = glm::dot(hinge.axis, glm::cross(hinge.upper, across));
  return hinge;
}

Hinge pose_hinge(const Bones& bones, const V& bend, const V& wish) noexcept {
  Hinge hinge;
  const V upper = normalised_or(bones.upper_here, normalised_or(bones.lower, V(1, 0, 0)));
  const double sine = safe_length(bend);
  if (sine >= two_bones::kStraight) {
    hinge.axis = bend / sine;
  } else {
    const V wanted = unit_beside(normalised_or(wish, V(0.0)), upper, perpendicular_to(upper));
    hinge.axis = unit_beside(two_bones::blended_side(bend, wanted, two_bones::kStraight), upper, wanted);
  }
  measure(bones, hinge);
  hinge.b = safe_length(bones.lower);
  const double aside = glm::dot(bones.lower, hinge.axis);
  const V across = bones.lower - hinge.axis * aside;
  if (std::abs(aside) > 1e-14 * hinge.b)
    hinge.flatten = rotation_between(bones.lower, normalised_or(across, bones.lower));
  hinge.cosine = glm::dot(hinge.upper, across);
  hinge.sine = glm::dot(hinge.axis, glm::cross(hinge.upper, across));
  return hinge;
}

Reach reach_of(const Bones& bones, const Hinge& hinge, double least_bend, double most_bend) noexcept {
  Reach reach;
  if (!can_bend(bones, hinge)) {
    reach.least = reach.most = safe_length(bones.upper + bones.to_root * bones.lower);
    return reach;
  }
  reach.least_bend = least_bend;
  reach.most_bend = most_bend;
  if (bones.is_even) {
    reach.most = even_distance(bones, hinge, least_bend);
    reach.least = std::min(reach.most, even_distance(bones, hinge, most_bend));
    return reach;
  }
  constexpr double kAside = 0.8;  // uneven scale seldom moves extremes farther from straight and folded
  if (least_bend == 0.0) reach.least_bend = extremum(bones, hinge, -kAside, kAside, 1.0);
  if (most_bend >= std::numbers::pi - 1e-6)
    reach.most_bend = extremum(bones, hinge, std::numbers::pi - kAside, std::numbers::pi + kAside, -1.0);
  reach.most = distance_at(bones, hinge, reach.least_bend);
  reach.least = std::min(reach.most, distance_at(bones, hinge, reach.most_bend));
  return reach;
}

Q bend_to(const Bones& bones, const Hinge& hinge, const Reach& reach, double distance) noexcept {
  if (!can_bend(bones, hinge)) return quat_identity<double>();
  double cosine = 1.0, sine = 0.0;
  if (bones.is_even) {
    const double whole = distance / bones.scale, a = hinge.a, b = hinge.b;
    const double flat = std::sqrt(std::max(0.0, (whole - hinge.along) * (whole + hinge.along)));
    const double d = std::clamp(flat, std::abs(a - b), a + b);
    const two_bones::CornerT<double> place = two_bones::corner(a, b, d);
    cosine = place.x * (d - place.x) - place.y * place.y;
    sine = place.y * d;
  } else {
    double straight = reach.least_bend, folded = reach.most_bend;
    for (int i = 0; i < 60; ++i) {
      const double middle = (straight + folded) / 2.0;
      (distance_at(bones, hinge, middle) > distance ? straight : folded) = middle;
    }
    cosine = std::cos(folded);
    sine = std::sin(folded);
  }
  // Cosine and sine of the turn from the current bend to the wanted bend, by the formulas for a difference of angles.
  const double c = cosine * hinge.cosine + sine * hinge.sine, s = sine * hinge.cosine - cosine * hinge.sine;
  return turn_about(hinge.axis, c, s) * hinge.flatten;
}

}  // namespace sinew::ik
