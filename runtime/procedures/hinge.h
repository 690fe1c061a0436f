// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/procedures/pole.h"

namespace sinew::ik {

/// The triangle of a limb (root, middle, tip) whose middle joint turns about one axis. Internal to procedures/

/// The two bones of a limb. "Here" is the space of the middle joint's parent, with the root joint as origin.
struct Bones {
  Mat3<double> to_root{1.0};  ///< linear map from here to the space of the root joint, with that joint's scale
  Vec3<double> upper{0.0};    ///< from root joint to middle joint, in the space of the root joint
  Vec3<double> upper_here{0.0}, lower{0.0};
  double length_here = 0.0;  ///< length of the straight limb, measured here
  double scale = 1.0;        ///< scale factor of to_root if it scales evenly
  bool is_even = true;       ///< to_root keeps angles, so the triangle can be solved in closed form
  bool is_flat = false;      ///< to_root is singular: the middle joint is left as it is
};

Bones bones_of(const Mat3<double>& to_root, const Vec3<double>& upper, const Vec3<double>& lower) noexcept;

/// Axis about which the bones are bent by a positive angle. Its length is the sine of the angle, so it is zero for a
/// straight limb.
Vec3<double> bend_axis(const Bones& bones) noexcept;

/// How a limb can bend. The bend angle is measured between the components of both bones perpendicular to the axis.
struct Hinge {
  Vec3<double> axis{0.0, 0.0, 1.0};          ///< unit
  Vec3<double> upper{1.0, 0.0, 0.0};         ///< unit direction of the upper bone, perpendicular to the axis
  double a = 0.0, b = 0.0;                   ///< lengths of upper and lower bone perpendicular to the axis
  double along = 0.0;                        ///< sum of both bones' components along the axis
  double lower_along = 0.0;                  ///< component of the lower bone along the axis
  double cosine = 1.0, sine = 0.0;           ///< of the current bend angle
  Quat<double> flatten{1.0, 0.0, 0.0, 0.0};  ///< w x y z; brings the lower bone into the plane of the bend
};

/// Finds the hinge of a limb.
/// in   given  axis of the hinge, of any length. Zero: the axis about which the pose bends. For a straight pose it
///      blends to rest_axis(), and if the limb is straight at rest, to the plane of the pole
template <class RestAxis>
Hinge hinge_of(const Bones& bones, const Vec3<double>& given, const Vec3<double>& pole_at_root,
               const RestAxis& rest_axis) noexcept;

/// Smallest and largest distance between root and tip, in the space of the root joint, and the bends that give them.
struct Reach {
  double least = 0.0, most = 0.0;
  double least_bend = 0.0, most_bend = 0.0;
};

Reach reach_of(const Bones& bones, const Hinge& hinge, double least_bend, double most_bend) noexcept;

/// Turn of the middle joint after which the tip has this distance from the root. The distance lies within `reach`.
Quat<double> bend_to(const Bones& bones, const Hinge& hinge, const Reach& reach, double distance) noexcept;

/// Hinge about a given axis.
Hinge fixed_hinge(const Bones& bones, const Vec3<double>& axis) noexcept;

/// Hinge about the axis of a pose (`bend`). If the bones are nearly straight, the axis blends to `wish`, a direction of
/// any length.
Hinge pose_hinge(const Bones& bones, const Vec3<double>& bend, const Vec3<double>& wish) noexcept;

/// Axis about which a straight limb bends towards a pole.
Vec3<double> axis_towards(const Bones& bones, const Vec3<double>& pole_at_root) noexcept;

template <class RestAxis>
Hinge hinge_of(const Bones& bones, const Vec3<double>& given, const Vec3<double>& pole_at_root,
               const RestAxis& rest_axis) noexcept {
  if (given != Vec3<double>(0.0)) return fixed_hinge(bones, given);
  const Vec3<double> bend = bend_axis(bones);
  if (safe_length(bend) >= two_bones::kStraight) return pose_hinge(bones, bend, bend);
  const Vec3<double> rest = rest_axis();
  const bool is_bent = safe_length(rest) >= two_bones::kStraight;
  return pose_hinge(bones, bend, is_bent ? rest : axis_towards(bones, pole_at_root));
}

}  // namespace sinew::ik
