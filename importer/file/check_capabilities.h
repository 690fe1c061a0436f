// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// What must hold before the rest of a document is worth reading.
/// in   json with the right shape
/// err  asset-version, extension-required by name (G57), too-many (G68);  warning asset-minor-version
void check_capabilities(const gltf::Json& json, std::uint32_t max_nodes, IssueLog& log);

}  // namespace sinew
