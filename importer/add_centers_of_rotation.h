// SPDX-License-Identifier: MIT
#pragma once
#include "importer/topology/centers_of_rotation.h"
#include "runtime/model/scene.h"

namespace sinew {

/// Fills Primitive::centers_of_rotation of every skinned primitive that has none, for Skinning::center_of_rotation.
/// Only meshes that an instance uses with a skin are looked at. All primitives of a mesh are treated as one surface,
/// whatever their materials: vertices at the same place get the same center, so no seam opens between materials.
/// A vertex without a center of its own gets its own position (see centers_of_rotation.h).
/// in    scene     has passed check(Scene)
///       options   progress runs once from 0 to 1 over all meshes
/// cost  that of centers_of_rotation() for each mesh
void add_centers_of_rotation(Scene& scene, const CentersOptions& options = {});

}  // namespace sinew
