// SPDX-License-Identifier: MIT
#pragma once
#include "importer/topology/centers_of_rotation.h"
#include "runtime/model/scene.h"

namespace sinew {

/// Fills missing Primitive::centers_of_rotation of skinned primitives, for Skinning::center_of_rotation. Considers only
/// meshes that an instance uses with a skin. All primitives of a mesh form one surface: vertices at the same position
/// get the same center, so no seam opens between materials. A vertex for which no center can be computed gets its own
/// position (see centers_of_rotation.h).
/// in    scene     has passed check(Scene)
///       options   progress goes once from 0 to 1 over all meshes
/// cost  that of centers_of_rotation(), for each mesh
void add_centers_of_rotation(Scene& scene, const CentersOptions& options = {});

}  // namespace sinew
