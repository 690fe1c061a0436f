// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/model/scene.h"
#include "runtime/plan/frame_result.h"

namespace sinew::viewer {

/// How far the vertices of two evaluations of one scene are apart.
struct VertexDistances {
  std::vector<std::vector<float>> primitives;  ///< [primitives of the frame][vertices] metres, world space
  double worst_m = 0.0, mean_m = 0.0;
  std::uint32_t worst_primitive = 0, worst_vertex = 0;  ///< the first of the farthest vertices
  std::size_t vertices = 0;
};

/// Compares the vertices of all mesh instances that both frames show.
/// eq   |M_a x_a - M_b x_b|, M the matrix that places the vertices in the world
/// in   a, b  frames of plans of scenes with the same meshes and instances
/// cost O(vertices), allocates
VertexDistances vertex_distances(const Scene& scene, const FrameResult& a, const FrameResult& b);

/// The scene with white, rough materials and vertex colours that show distances: blue 0, green half, red `full_m` and
/// more. A mesh that several instances show gets the largest distance of each vertex.
/// in   full_m  above 0
Scene painted_scene(const Scene& scene, const FrameResult& frame, const VertexDistances& distances, double full_m);

}  // namespace sinew::viewer
