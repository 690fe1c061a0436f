// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/model/scene.h"

namespace sinew::test {

/// One triangle (0 0 0) (1 0 0) (0 1 0), normals +z, on one root joint. Nothing moves.
Scene prop_scene();

/// Joints 0 `upper` and 2 `lower`, one metre above it, with a flat arm of two triangles in the plane z = 0, skinned to
/// both. The clip "bend" turns `lower` by 90 degrees about +z in one second. Vertices:
///   0 (0 0 0) upper;  1 (0 2 0) lower;  2 (0.25 1 0) both, half and half;  3 (-0.25 1 0) both
/// The mesh hangs on the unmoved node "holder", five metres aside. The node of a skinned mesh does not place it, so
/// this must have no effect.
Scene arm_scene();

/// A quad of side 2 around the origin, normals +z, with colours and two targets. "lift" moves vertex 0 by (0 0 1) and
/// adds (1 0 0) to its normal.
/// "spread" moves vertices 1 and 2 by (1 0 0) and adds (0.5 0 0 0) to their colour. Rest weights (0.25, 0). The clip
/// "smile" takes the weights from (0, 0) to (1, 2) in one second.
Scene face_scene();

}  // namespace sinew::test
