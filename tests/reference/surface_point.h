// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "runtime/math/affine.h"
#include "runtime/model/scene.h"
#include "runtime/plan/frame_result.h"

namespace sinew::reference {

/// A line of sight, world space. t = 1 lies 1 m in front of the eye plane.
struct SightLine {
  glm::dvec3 from{0.0}, direction{0.0, 0.0, -1.0};
};

/// The axes of a normal map on a surface, beside its normal.
struct TangentFrame {
  glm::dvec3 tangent{0.0}, bitangent{0.0};
};

/// A point where a line of sight meets a triangle that is drawn.
struct SurfacePoint {
  Material material;
  double distance_m = 0.0;  ///< from the eye plane
  bool front = true;        ///< its counter-clockwise side is seen
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0.0};  ///< unit, towards the outside; zero if the primitive has none
  std::array<glm::dvec2, 2> uv{};
  std::array<TangentFrame, 2> frames{};  ///< of each set of texture coordinates; with tangents they are the same
  glm::dvec4 color{1.0};                 ///< of the vertices
  glm::dvec3 to_viewer{0.0};
};

/// All triangles of the scene that the line meets, the nearest first; back sides of one-sided materials are not drawn.
/// Every triangle is tried. Copies, points and lines are not known here.
/// eq   n' = inverse transpose of M * n, t' = M * t, bitangent = w * cross(n', t'), the other way where M mirrors
///      (runtime/math/conventions.h). Without tangents: along u, and w so that v falls.
std::vector<SurfacePoint> surfaces_along(const Scene& scene, const FrameResult& frame, const SightLine& line);

}  // namespace sinew::reference
