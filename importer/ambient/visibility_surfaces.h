// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "importer/ambient/bake_ambient_visibility.h"
#include "runtime/model/scene.h"
#include "runtime/model/vertex_visibility.h"
#include "runtime/plan/frame_result.h"

namespace sinew {

/// A primitive of the scene, transformed to world space.
struct PlacedSurface {
  std::uint32_t mesh = 0, primitive = 0;
  VisibilitySurface surface;
};

/// The triangles of a frame in world space, one surface for each primitive of each mesh instance and of its copies.
/// Omits hidden instances, points and lines. Reverses the winding of mirrored placements. Surfaces of flat primitives
/// have no normals. Blended materials do not block light; alpha-masked triangles block it everywhere.
/// in   frame  with positions
std::vector<PlacedSurface> surfaces_of(const Scene& scene, const FrameResult& frame);

/// Default ray length: long enough for self-occlusion of a body, but shorter than a room, whose inside would be black.
/// eq   a quarter of the longest side of the box around all surfaces
double default_visibility_distance_m(const Scene& scene, const FrameResult& frame);

/// Bakes the ambient visibility of a scene in a frame's pose.
/// err, cost  as bake_ambient_visibility()
MeshVisibility bake_mesh_visibility(const Scene& scene, const FrameResult& frame, const VisibilityOptions& options);

}  // namespace sinew
