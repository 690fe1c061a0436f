// SPDX-License-Identifier: MIT
#pragma once
#include <tl/expected.hpp>

#include "runtime/base/api.h"
#include "runtime/geometry_cache/bind_geometry.h"
#include "runtime/geometry_cache/geometry_decoder.h"
#include "runtime/model/scene.h"

namespace sinew {

/// A scene made from a cache alone, for programs that have no other file of it.
struct CacheScene {
  /// For each mesh of the cache: a node, a mesh, an instance and a double-sided material of its name. Its rest shape is
  /// the first frame. A mesh without triangles is shown as points.
  Scene scene;
  std::vector<GeometryBinding> bindings;  ///< bindings for GeometryPlayer: mesh i plays in instance i
};

/// Normals are those of the cache, or else smooth over points of equal position. Colours are those of the first frame.
/// in   frames  must have the first frame loaded
/// err  GeometryStatus of that frame;   cost O(vertices), allocates
SINEW_API tl::expected<CacheScene, GeometryStatus> scene_of(const GeometryCache& cache, FrameSource frames);

}  // namespace sinew
