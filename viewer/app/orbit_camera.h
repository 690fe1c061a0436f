// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "viewer/passes/view.h"

namespace sinew::viewer {

/// A camera that turns around a point. Angles and lengths in double precision; one drag over the window's height turns
/// half around, and a point under the mouse stays under it while moving the camera sideways.
class OrbitCamera {
 public:
  static constexpr double kSteepest_rad = 1.55;  ///< just short of straight down, where "up" has no meaning

  glm::dvec3 target{0.0};
  double distance_m = 3.0;
  double yaw_rad = 0.4636;    ///< 0 = from +z, the side that a glTF model faces; grows to the right
  double pitch_rad = 0.3035;  ///< above the horizon
  double fov_y_rad = 0.785398163397448;

  glm::dvec3 eye() const noexcept;

  /// in   dx, dy  pixels, y down;   height  of the window in pixels
  void orbit(double dx, double dy, double height) noexcept;
  void pan(double dx, double dy, double height) noexcept;

  /// Nearer by a tenth for each step, farther for negative ones; stays between a thousandth and a thousand times the
  /// size of what was framed last.
  void zoom(double steps) noexcept;

  /// Moves, without turning, to where all points are just inside the picture and in its middle. The target lies halfway
  /// between the nearest and the farthest point. No points, or a single one, count as a cube of 1 m around it.
  /// eq   in camera axes x, y, z (z towards the eye), with the slopes s of the picture's edges:
  ///      a = max(x + s z), b = max(-x + s z):  eye.x = (a - b) / 2,  eye.z = (a + b) / (2 s);  y alike, the farther z
  ///      counts; then 8 percent farther from the target
  void frame(std::span<const glm::vec3> points, double aspect) noexcept;
  void frame(const Aabb& bounds, double aspect) noexcept;  ///< its corners

  /// Stands at `eye` and looks at `to`. Nothing changes when the two are the same point.
  void place(const glm::dvec3& eye, const glm::dvec3& to) noexcept;

  /// Goes on from where another view is, upright and round the middle of `bounds`' depth, so that a hand on the mouse
  /// moves the picture that is seen. A parallel view becomes a perspective one that shows as much at that depth.
  void take_over(const View& view, const Aabb& bounds) noexcept;

  /// What the renderer takes, with a near plane for a scene of these bounds.
  View view(const Aabb& bounds) const;

 private:
  double scale_m_ = 3.0;  ///< size of what was framed last
};

}  // namespace sinew::viewer
