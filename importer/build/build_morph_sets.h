// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "runtime/model/mesh.h"

namespace sinew {

/// Stores the morph targets of a primitive as sparse deltas: vertices that a target does not move have no entry.
/// in    primitive      with its vertices in final order
///       target_count   of the mesh; missing targets of the primitive become empty
/// out   primitive.morphs
/// cost  O(values in the file); holds one target at a time
void build_morph_set(const gltf::Document& document, std::uint32_t mesh, std::uint32_t index, std::size_t target_count,
                     Primitive& primitive, IssueLog& log);

}  // namespace sinew
