// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/passes/view.h"

namespace sinew::viewer {

/// A camera that turns around a point. Angles and lengths in double precision; one drag over the window's height turns
/// half around, and a point under the mouse stays under it while moving the camera sideways.
class OrbitCamera {
 public:
  static constexpr double kSteepest_rad = 1.55;      ///< just short of straight down, where "up" has no meaning

  glm::dvec3 target{0.0};
  double distance_m = 3.0;
  double yaw_rad = 0.4636;      ///< 0 = from +z, the side that a glTF model faces; grows to the right
  double pitch_rad = 0.3035;    ///< above the horizon
  double fov_y_rad = 0.785398163397448;

  glm::dvec3 eye() const noexcept;

  /// in   dx, dy  pixels, y down;   height  of the window in pixels
  void orbit(double dx, double dy, double height) noexcept;
  void pan(double dx, double dy, double height) noexcept;

  /// Nearer by a tenth for each step, farther for negative ones; stays between a thousandth and a thousand times the
  /// size of what was framed last.
  void zoom(double steps) noexcept;

  /// Moves, without turning, to where the whole box is just inside the picture. An empty box counts as the unit cube
  /// around the origin, one without any extent as a cube of its magnitude.
  /// eq   distance = max over corners c of max(|c.x| / (tan(fov/2) aspect), |c.y| / tan(fov/2)) + c.z, in camera axes
  ///      from the box's centre, times a margin of 1.08
  void frame(const Aabb& bounds, double aspect) noexcept;

  /// Stands at `eye` and looks at `to`. Nothing changes when the two are the same point.
  void place(const glm::dvec3& eye, const glm::dvec3& to) noexcept;

  /// What the renderer takes, with a near plane for a scene of these bounds.
  View view(const Aabb& bounds) const;

 private:
  double scale_m_ = 3.0;   ///< size of what was framed last
};

}  // namespace sinew::viewer
