// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "importer/file/document.h"
#include "importer/import_gltf.h"
#include "importer/issue_log.h"
#include "runtime/model/mesh.h"
#include "runtime/model/scene.h"

namespace sinew {

/// Builds every mesh of the document, primitive by primitive: vertices are grouped by number of influences, morph
/// targets are sparse, and missing normals and tangents are made where the options ask for them.
/// err      those of read_primitive, read_morph_target and merge_influences
/// warning  mesh-target-count, mesh-weights-count (short lists are filled with zeros, long ones cut)
std::vector<Mesh> build_meshes(const gltf::Document& document, const ImportOptions& options, IssueLog& log);

/// Warns where a material, also that of a variant, uses texture coordinates that the mesh does not have.
/// in       scene   with its materials, textures and meshes
/// warning  mesh-texcoord-missing
/// cost     O(primitives)
void check_texcoords(const Scene& scene, IssueLog& log);

}  // namespace sinew
