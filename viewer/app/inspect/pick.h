// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "runtime/model/scene.h"
#include "runtime/plan/frame_result.h"
#include "viewer/app/inspect/inspected.h"
#include "viewer/passes/view.h"

namespace sinew::viewer {

/// A ray in world space; the direction is unit.
struct Ray {
  glm::dvec3 from{0.0}, along{0.0, 0.0, -1.0};
};

/// The ray of sight through a point of the picture.
/// in   x, y  -1 to 1, y up;   aspect  width / height
Ray ray_through(const View& view, double aspect, double x, double y) noexcept;

/// The vertex nearest to the first point where the ray meets a visible triangle, from either side.
/// eq   Moeller and Trumbore 1997, in double; of the corners, the one with the largest barycentric weight
/// cost O(triangles)
std::optional<VertexPlace> pick_vertex(const Scene& scene, const FrameResult& frame, const Ray& ray);

/// World position of a vertex in a frame; of the first copy of its mesh.
/// in   vertex  of an instance of the scene
glm::dvec3 position_of(const Scene& scene, const FrameResult& frame, const VertexPlace& vertex);

/// A joint and how much it moves a vertex.
struct Influence {
  std::uint32_t joint = kNone;
  float weight = 0.0f;
};

/// The joints that move a vertex, the strongest first. A mesh without a skin is moved by its own joint alone.
std::vector<Influence> influences_of(const Scene& scene, const VertexPlace& vertex);

}  // namespace sinew::viewer
