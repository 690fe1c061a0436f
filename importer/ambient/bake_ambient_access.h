// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace sinew {

/// Triangles in the world that block light and receive it.
struct AccessSurface {
  std::vector<glm::vec3> positions;  ///< [V] world space, metres
  /// [V] or empty. Vertices at one place with one normal are one vertex, so that no seam opens where only texture
  /// coordinates differ. Without normals each vertex stands alone.
  std::vector<glm::vec3> normals;
  std::vector<std::uint32_t> indices;  ///< three a triangle, counter-clockwise seen from its front
  bool both_sides = false;             ///< blocks rays from behind, too
  bool blocks = true;                  ///< false: light passes through, as through blended materials
};

struct AccessOptions {
  std::uint32_t rays = 256;  ///< a vertex, shared by its faces; at least one a face
  /// Only surfaces nearer than this block light; infinite = all do, and the inside of a closed box is black.
  double distance_m = std::numeric_limits<double>::infinity();
  std::uint64_t seed = 1;
  std::function<void(double)> progress = {};  ///< receives the finished part, 0 to 1; may be empty
};

/// Ambient access of each vertex: the fraction of light from all around that arrives, for Lambert's law.
/// eq   sum over its faces of angle * (unblocked rays / rays), divided by the sum of angles; each face casts
///      ceil(rays / faces) rays over its own hemisphere from a point slightly inside it
///      (importer/ambient/access_rays.h); angle: of the face at the vertex, so that it does not matter how a polygon is
///      cut into triangles
/// out  [surfaces][V] in [0, 1]; 1 at vertices that no triangle with an area uses
/// err  std::runtime_error when Embree has no memory
/// cost O(vertices * rays * log triangles), on all threads of oneTBB; the same numbers for any number of them
std::vector<std::vector<float>> bake_ambient_access(std::span<const AccessSurface> surfaces,
                                                    const AccessOptions& options = {});

}  // namespace sinew
