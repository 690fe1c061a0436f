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

/// Tangent and bitangent of a surface: the axes of its normal map.
struct TangentFrame {
  glm::dvec3 tangent{0.0}, bitangent{0.0};
};

/// A point where a line of sight meets a triangle that is drawn.
struct SurfacePoint {
  Material material;
  double distance_m = 0.0;  ///< from the eye plane
  bool front = true;        ///< the viewer sees the counter-clockwise side
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0.0};  ///< unit, towards the outside; zero if the primitive has none
  std::array<glm::dvec2, 2> uv{};
  std::array<TangentFrame, 2> frames{};  ///< one per set of texture coordinates; stored tangents serve all sets
  glm::dvec4 color{1.0};                 ///< vertex colour
  glm::dvec3 to_viewer{0.0};
  double scale = 1.0;  ///< of the mesh in the world: the cube root of its volume's
};

/// All triangles of the scene that the line meets, the nearest first. Every triangle is tried. Back sides of one-sided
/// materials are left out. Instance copies, points and lines are not supported.
/// eq   n' = inverse transpose of M * n, t' = M * t, bitangent = w * cross(n', t'), reversed where M mirrors
///      (runtime/math/conventions.h). Without stored tangents: t along u, and w so that v falls along the bitangent.
std::vector<SurfacePoint> surfaces_along(const Scene& scene, const FrameResult& frame, const SightLine& line);

}  // namespace sinew::reference
