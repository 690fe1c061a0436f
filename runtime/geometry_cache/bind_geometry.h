// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/geometry_cache/geometry_cache.h"
#include "runtime/model/scene.h"

namespace sinew {

/// The mesh of a cache that a primitive of a mesh instance takes its vertices from.
struct GeometryBinding {
  std::uint32_t instance = 0, primitive = 0;
  std::uint32_t mesh = 0;  ///< of the cache
};

struct GeometryBindings {
  std::vector<GeometryBinding> bound;  ///< all primitives of each instance that plays, in the order of the scene
  std::vector<std::string> unbound;  ///< meshes of the cache and instances of the scene that share a name with one and
                                     ///< do not fit, a sentence each
};

/// Binds by name, as `sinew bake` names meshes: the mesh's own name, or name and index of the primitive where it has
/// several. Of several instances with one name the first takes the first mesh of that name, and so on.
/// cost O(meshes * instances + corners), allocates
GeometryBindings bind_by_name(const GeometryCache& cache, const Scene& scene);

/// The vertex of the cache that each vertex of a primitive takes. Where the cache keeps triangles, corner for corner:
/// so vertices may be in another order, and split at seams. Else both have the same vertices in the same order.
/// err  size_mismatch  another number of triangles, or of vertices
///      unsupported    a vertex would take several; cost O(corners), allocates
Result<std::vector<std::uint32_t>> match_vertices(const GeometryMesh& mesh, const Primitive& primitive);

/// Whether a player may use them.
/// err  index_out_of_range   no such instance, primitive or mesh
///      unsupported          an instance of which only some primitives are bound, or one twice
///      those of match_vertices
ErrorCode check(const GeometryCache& cache, const Scene& scene, std::span<const GeometryBinding> bindings);

}  // namespace sinew
