// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "runtime/math/transform.h"

namespace sinew {

/// The accessors of EXT_mesh_gpu_instancing on a node, by attribute name; empty if the node lacks the extension.
/// err      reference
/// warning  extension-value
std::map<std::string, std::uint32_t> copy_attributes(const gltf::Document& document, std::uint32_t node, IssueLog& log);

/// Transforms of the instanced copies of a node's mesh, in the node's space.
/// out      no value without the extension or after an error; an empty list = the mesh is not shown
/// err      as copy_attributes; instancing-attributes, not-finite
/// warning  rotation-zero, rotation-length
std::optional<std::vector<Transform>> read_mesh_copies(const gltf::Document& document, std::uint32_t node,
                                                       IssueLog& log);

}  // namespace sinew
