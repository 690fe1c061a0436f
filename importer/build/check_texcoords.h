// SPDX-License-Identifier: MIT
#pragma once
#include "importer/issue_log.h"
#include "runtime/model/scene.h"

namespace sinew {

/// Warns where a material uses texture coordinates that the mesh does not have.
/// in   materials, textures and meshes of the scene.   warning mesh-texcoord-missing.   cost O(primitives)
void check_texcoords(const Scene& scene, IssueLog& log);

}  // namespace sinew
