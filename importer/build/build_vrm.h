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

/// Reads the VRM 0.x or 1.0 data of a file. If it has both, 1.0 is used.
/// in       instance_of_node[N]   mesh instance of each node; kNone = none
/// out      null if the file has none of these extensions
/// err      memory-budget
/// warning  extension-value
std::shared_ptr<const VrmCharacter> build_vrm(const gltf::Document& document, const JointOrder& order,
                                              const std::vector<std::uint32_t>& instance_of_node, IssueLog& log);

}  // namespace sinew
