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

/// Builds all meshes of the document. Groups vertices by number of influences, stores morph targets sparsely, and makes
/// missing normals and tangents if the options ask for it.
/// err      as read_primitive, read_morph_target and merge_influences
/// warning  mesh-target-count, mesh-weights-count (short lists are filled with zeros, long ones cut)
std::vector<Mesh> build_meshes(const gltf::Document& document, const ImportOptions& options, IssueLog& log);

/// Warns if a material, including those of variants, uses texture coordinates that the mesh lacks.
/// in       scene   has its materials, textures and meshes
/// warning  mesh-texcoord-missing
/// cost     O(primitives)
void check_texcoords(const Scene& scene, IssueLog& log);

}  // namespace sinew
