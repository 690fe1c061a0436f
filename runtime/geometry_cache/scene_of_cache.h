// SPDX-License-Identifier: MIT
#pragma once
#include <tl/expected.hpp>

#include "runtime/geometry_cache/bind_geometry.h"
#include "runtime/geometry_cache/geometry_decoder.h"
#include "runtime/model/scene.h"

namespace sinew {

/// A cache as a scene of its own, for programs that have no other file of it.
struct CacheScene {
  Scene scene;  ///< for each mesh of the cache a node, a mesh, an instance and a double-sided material, with its name;
                ///< at rest as in the first frame. Without triangles a mesh is shown as points
  std::vector<GeometryBinding> bindings;  ///< for GeometryPlayer: mesh i plays in instance i
};

/// Normals are those of the cache, else smooth over the points of its positions; colours are those of the first frame.
/// in   frames  has the first frame
/// err  GeometryStatus of that frame;   cost O(vertices), allocates
tl::expected<CacheScene, GeometryStatus> scene_of(const GeometryCache& cache, FrameSource frames);

}  // namespace sinew
