// SPDX-License-Identifier: MIT
#pragma once
#include "importer/topology/centers_of_rotation.h"
#include "runtime/model/scene.h"

namespace sinew {

/// Gives Primitive::centers_of_rotation to every skinned primitive that has none, for Skinning::center_of_rotation. All
/// primitives of a mesh are one surface, whatever their materials: vertices that coincide get the same center, and no
/// seam opens. Vertices without a center of their own get their own position (centers_of_rotation.h). in   scene   that
/// passed check(Scene); only meshes that some instance hangs on a skin are looked at cost that of centers_of_rotation;
/// progress runs once from 0 to 1 over all meshes
void add_centers_of_rotation(Scene& scene, const CentersOptions& options = {});

}  // namespace sinew
