// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace sinew {

/// Triangles in world space that receive light and may block it.
struct VisibilitySurface {
  std::vector<glm::vec3> positions;  ///< [V] world space, metres
  /// [V] or empty. Vertices with equal position and normal count as one, so texture seams do not show. Without normals,
  /// each vertex is separate.
  std::vector<glm::vec3> normals;
  std::vector<std::uint32_t> indices;  ///< three per triangle, counter-clockwise seen from the front
  bool both_sides = false;             ///< true = also blocks rays that hit the back
  bool blocks = true;                  ///< false = light passes through, as for blended materials
};

struct VisibilityOptions {
  std::uint32_t rays = 256;  ///< rays per vertex, divided among its faces; at least one per face
  /// Only surfaces nearer than this block light. Infinite = all do, so the inside of a closed box is black.
  double distance_m = std::numeric_limits<double>::infinity();
  std::uint64_t seed = 1;
  std::function<void(double)> progress = {};  ///< receives the finished fraction, 0 to 1; may be empty
};

/// Ambient visibility of each vertex: the cosine-weighted fraction of the hemisphere that is not blocked.
/// eq   sum over its faces of angle * (unblocked rays / rays), divided by the sum of angles; each face casts ceil(rays
///      / faces) rays over its own hemisphere from a point slightly inside it (importer/ambient/visibility_rays.h);
///      angle: of the face at the vertex, so that the triangulation of a polygon does not matter
/// out  [surfaces][V] in [0, 1]; 1 at vertices without any triangle of positive area
/// err  std::runtime_error if Embree runs out of memory
/// cost O(vertices * rays * log triangles), on all threads of oneTBB; results do not depend on the thread count
std::vector<std::vector<float>> bake_ambient_visibility(std::span<const VisibilitySurface> surfaces,
                                                        const VisibilityOptions& options = {});

}  // namespace sinew
