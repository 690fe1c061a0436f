// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/procedures/pole.h"

namespace sinew::ik {

/// The triangle of a limb whose middle joint turns about one axis. Internal to procedures/

/// Both bones. "Here" is the space of the middle joint's parent, at the place of the root joint.
struct Bones {
  Mat3<double> to_root{1.0};  ///< linear map from here to the space of the root joint, with that joint's scale
  Vec3<double> upper{0.0};    ///< from root joint to middle joint, in the space of the root joint
  Vec3<double> upper_here{0.0}, lower{0.0};
  double length_here = 0.0;  ///< of the straight limb
  double scale = 1.0;        ///< of to_root, if it is even
  bool is_even = true;       ///< to_root keeps angles, so the triangle has a closed form
  bool is_flat = false;      ///< to_root flattens space: the middle joint stays as it is
};

Bones bones_of(const Mat3<double>& to_root, const Vec3<double>& upper, const Vec3<double>& lower) noexcept;

/// Unit axis about which bones are bent by a positive angle, times the sine of that angle; zero for a straight limb.
Vec3<double> bend_axis(const Bones& bones) noexcept;

/// How a limb can bend. The bend is the angle between the parts of both bones perpendicular to the axis.
struct Hinge {
  Vec3<double> axis{0.0, 0.0, 1.0};          ///< unit
  Vec3<double> upper{1.0, 0.0, 0.0};         ///< unit direction of the upper bone, perpendicular to the axis
  double a = 0.0, b = 0.0;                   ///< lengths of the bones perpendicular to the axis
  double along = 0.0;                        ///< length of both along the axis
  double lower_along = 0.0;                  ///< that of the lower bone
  double cosine = 1.0, sine = 0.0;           ///< of the bend now
  Quat<double> flatten{1.0, 0.0, 0.0, 0.0};  ///< w x y z; brings the lower bone into the plane of the bend
};

/// in   given  axis that the limb has, of any length; zero: the axis of the pose, which blends to that of `rest_axis()`
///             where the limb is straight, and to the plane of the pole if it is straight at rest, too
template <class RestAxis>
Hinge hinge_of(const Bones& bones, const Vec3<double>& given, const Vec3<double>& pole_at_root,
               const RestAxis& rest_axis) noexcept;

/// Distances between root and tip, in the space of the root joint, and the bends that have them.
struct Reach {
  double least = 0.0, most = 0.0;
  double least_bend = 0.0, most_bend = 0.0;
};

Reach reach_of(const Bones& bones, const Hinge& hinge, double least_bend, double most_bend) noexcept;

/// Turn of the middle joint that brings the tip to a distance within the reach.
Quat<double> bend_to(const Bones& bones, const Hinge& hinge, const Reach& reach, double distance) noexcept;

/// Hinge about an axis that the caller gives.
Hinge fixed_hinge(const Bones& bones, const Vec3<double>& axis) noexcept;

/// Hinge of a pose, or for bones that are nearly in one line the blend to `wish`, a direction of any length.
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
