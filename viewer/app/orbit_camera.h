// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "viewer/passes/view.h"

namespace sinew::viewer {

/// The part of a picture that nothing covers, from its left edge (-1) to its right one (1).
struct FreeWidth {
  double left = -1.0, right = 1.0;

  friend bool operator==(const FreeWidth&, const FreeWidth&) = default;
};

/// A camera that orbits a target point. A drag over the height of the window turns by 180 degrees; while panning, the
/// point under the mouse stays under it.
class OrbitCamera {
 public:
  static constexpr double kSteepest_rad = 1.55;  ///< straight up and down are excluded: "up" has no meaning there

  glm::dvec3 target{0.0};
  double distance_m = 3.0;
  double yaw_rad = 0.4636;    ///< 0 = from +z, the side that a glTF model faces; positive to the right
  double pitch_rad = 0.3035;  ///< above the horizon
  double fov_y_rad = 0.785398163397448;
  double aside = 0.0;  ///< where the picture shows the target: tangent of the angle to the right of straight ahead

  glm::dvec3 eye() const noexcept;

  /// in   dx, dy  pixels, y down;   height  of the window in pixels
  void orbit(double dx, double dy, double height) noexcept;
  void pan(double dx, double dy, double height) noexcept;

  /// Each step moves nearer by a tenth; negative steps move farther. The distance stays between a thousandth and a
  /// thousand times the size of what was framed last.
  void zoom(double steps) noexcept;

  /// Moves without turning so that all points are in the middle of what is free of the picture and fill 80 % of it: as
  /// large as its shape allows, less sqrt(0.8) of each side. The target lies halfway between the nearest and the
  /// farthest point. A single point counts as a cube of 1 m around it, no points as one around the origin.
  /// eq   in camera axes x, y, z (z towards the eye), with the slopes l < r of the edges that the points may reach:
  ///      a = max(x + r z), b = max(-x - l z):  eye.z = (a + b) / (r - l);  the same for y, and the larger eye.z is
  ///      used, at least 2 % of the depth of the points before the nearest;  eye.x = (a - b - (r + l) eye.z) / 2
  void frame(std::span<const glm::vec3> points, double aspect, const FreeWidth& free = {}) noexcept;
  void frame(const Aabb& bounds, double aspect, const FreeWidth& free = {}) noexcept;  ///< the corners of the box

  /// Moves to `eye` and looks at `to`. Nothing changes when the two are the same point.
  void place(const glm::dvec3& eye, const glm::dvec3& to) noexcept;

  /// Continues from another view, so that dragging starts with the picture that is shown: upright, orbiting the point
  /// straight ahead at the depth of the middle of `bounds`. A parallel view becomes a perspective one that shows the
  /// same height at that depth.
  void take_over(const View& view, const Aabb& bounds) noexcept;

  /// The view for the renderer, with a near plane for a scene of these bounds.
  View view(const Aabb& bounds) const;

 private:
  double scale_m_ = 3.0;  ///< size of what was framed last
};

}  // namespace sinew::viewer
