// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/geometry_cache/geometry_cache.h"
#include "runtime/model/scene.h"

namespace sinew {

/// A primitive of a mesh instance, and the mesh of a cache that it takes its vertices from.
struct GeometryBinding {
  std::uint32_t instance = 0, primitive = 0;
  std::uint32_t mesh = 0;  ///< index of the cache's mesh
};

struct GeometryBindings {
  std::vector<GeometryBinding> bound;  ///< all primitives of each instance that plays, in the order of the scene
  std::vector<std::string> unbound;    ///< a sentence for each mesh and instance that share a name but do not fit
};

/// Binds meshes of the cache to instances by name, as `sinew bake` names meshes. That is the name of the scene's mesh,
/// with the index of the primitive added if there are several. Instances of equal name take the meshes of that name in
/// order.
/// cost O(meshes * instances + corners), allocates
SINEW_API GeometryBindings bind_by_name(const GeometryCache& cache, const Scene& scene);

/// For each vertex of a primitive, the vertex of the cache mesh that moves it. If the cache stores triangles, corners
/// are matched one by one, so the scene may order vertices differently and split them at seams. Otherwise both must
/// have the same vertices in the same order.
/// err  size_mismatch  the numbers of triangles or vertices differ
///      unsupported    a vertex would match several; cost O(corners), allocates
SINEW_API Result<std::vector<std::uint32_t>> match_vertices(const GeometryMesh& mesh, const Primitive& primitive);

/// Checks that a player can use these bindings.
/// err  index_out_of_range   no such instance, primitive or mesh
///      unsupported          an instance has an unbound primitive, or a primitive that is bound twice
///      and those of match_vertices
SINEW_API ErrorCode check(const GeometryCache& cache, const Scene& scene, std::span<const GeometryBinding> bindings);

}  // namespace sinew
