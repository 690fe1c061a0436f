// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "importer/build/joint_order.h"
#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "importer/vrm.h"

namespace sinew {

/// Reads what VRM 0.x and 1.0 say about the character of a file. Where a file has both, 1.0 counts.
/// in       instance_of_node[N]   of a mesh, kNone for nodes without one
/// out      null where the file has none of these extensions
/// err      memory-budget
/// warning  extension-value
std::shared_ptr<const VrmCharacter> build_vrm(const gltf::Document& document, const JointOrder& order,
                                              const std::vector<std::uint32_t>& instance_of_node, IssueLog& log);

}  // namespace sinew
