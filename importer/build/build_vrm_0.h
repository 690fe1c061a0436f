// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "importer/build/joint_order.h"
#include "importer/file/document.h"
#include "importer/read/extension_fields.h"
#include "importer/vrm.h"

namespace sinew {

/// Limit of expanded VRM lists: binds times nodes, springs times colliders.
inline constexpr std::size_t kMostVrmEntries = std::size_t{1} << 18;

/// Reads the extension VRM, version 0.x, and converts it to VRM 1.0: bone and preset names, weights as fractions, z
/// axes with the opposite sign.
/// in       vrm   the extension
/// err      memory-budget
/// warning  extension-value
void read_vrm_0(const ExtensionFields& vrm, const gltf::Document& document, const JointOrder& order,
                const std::vector<std::uint32_t>& instance_of_node, VrmCharacter& out);

}  // namespace sinew
