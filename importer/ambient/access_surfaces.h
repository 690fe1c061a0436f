// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "importer/ambient/bake_ambient_access.h"
#include "runtime/model/scene.h"
#include "runtime/model/vertex_access.h"
#include "runtime/plan/frame_result.h"

namespace sinew {

/// A primitive of the scene where a frame places it.
struct PlacedSurface {
  std::uint32_t mesh = 0, primitive = 0;
  AccessSurface surface;
};

/// The triangles of a frame in world space, one surface for each primitive of each mesh instance and of its copies.
/// Hidden instances are left out, and so are points and lines. Mirrored placements have their winding reversed.
/// Surfaces of flat primitives have no normals. Blended materials block no light; where alpha masks cut, the whole
/// triangle blocks.
/// in   frame  with positions
std::vector<PlacedSurface> surfaces_of(const Scene& scene, const FrameResult& frame);

/// How far ambient access looks when nobody says: far enough for what a body hides of itself, and not from wall to wall
/// of a room, which would be black.
/// eq   a quarter of the longest side of the box around all surfaces
double default_access_distance_m(const Scene& scene, const FrameResult& frame);

/// Bakes the ambient access of a scene in the pose of a frame.
/// err, cost  those of bake_ambient_access()
MeshAccess bake_mesh_access(const Scene& scene, const FrameResult& frame, const AccessOptions& options);

}  // namespace sinew
