// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "viewer/passes/view.h"

namespace sinew::viewer {

/// Part of the picture that no panel covers. -1 = left or lower edge, 1 = right edge; the upper edge is always free.
struct FreePart {
  double left = -1.0, right = 1.0, bottom = -1.0;

  friend bool operator==(const FreePart&, const FreePart&) = default;
};

/// A camera that orbits a target point. Dragging over the full window height rotates by 180 degrees. While panning, the
/// point under the mouse stays under it.
class OrbitCamera {
 public:
  /// Largest pitch; looking straight up or down would leave the up direction undefined.
  static constexpr double kSteepest_rad = 1.55;

  glm::dvec3 target{0.0};
  double distance_m = 3.0;
  double yaw_rad = 0.4636;    ///< 0 = from +z, the side that a glTF model faces; positive to the right
  double pitch_rad = 0.3035;  ///< above the horizon
  double fov_y_rad = 0.785398163397448;
  /// Horizontal offset of the target in the picture: tangent of its angle to the right of the view direction.
  double aside = 0.0;
  double above = 0.0;  ///< the same, upwards

  glm::dvec3 eye() const noexcept;

  /// in   dx, dy  pixels, y down;   height  of the window in pixels
  void orbit(double dx, double dy, double height) noexcept;
  void pan(double dx, double dy, double height) noexcept;

  /// Each positive step shortens the distance by a tenth; negative steps lengthen it. The distance is clamped to 0.001
  /// to 1000 times the size of the points framed last.
  void zoom(double steps) noexcept;

  /// Moves, without rotating, so that all points are centered in the free part of the picture. They fill at most
  /// sqrt(0.8) of each side, which is 80 % of the area. The target's depth is halfway between the nearest and the
  /// farthest point. A single point counts as a 1 m cube around it; no points count as a 1 m cube around the origin.
  /// eq   in camera axes x, y, z (z towards the eye), with l < r the x/depth slopes of the limits that the points may
  ///      reach: a = max(x + r z), b = max(-x - l z):  eye.z = (a + b) / (r - l);  y gives a second eye.z, and the
  ///      larger one is used. It lies at least 2 % of the points' depth before the nearest point;  eye.x = (a - b - (r
  ///      + l) eye.z) / 2
  void frame(std::span<const glm::vec3> points, double aspect, const FreePart& free = {}) noexcept;
  /// Frames the corners of the box.
  void frame(const Aabb& bounds, double aspect, const FreePart& free = {}) noexcept;

  /// Moves to `eye` and looks at `to`. Does nothing if both are the same point.
  void place(const glm::dvec3& eye, const glm::dvec3& to) noexcept;

  /// Continues from another view, so that dragging starts from the current picture, made upright. The target becomes
  /// the point straight ahead at the depth of the middle of `bounds`. An orthographic view becomes a perspective one
  /// with the same visible height at that depth.
  void take_over(const View& view, const Aabb& bounds) noexcept;

  /// The view for the renderer. The near plane is chosen for a scene of these bounds.
  View view(const Aabb& bounds) const;

 private:
  double scale_m_ = 3.0;  ///< size of the points framed last
};

}  // namespace sinew::viewer
