// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "importer/file/json_tree.h"
#include "importer/issue_log.h"

namespace sinew {

/// False for a file of another major version of glTF: none of the other rules apply to it.
/// in    json   of any shape; a version that is missing or of the wrong type is left to the check of the shape
/// err   asset-version
bool check_major_version(const JsonNode& json, IssueLog& log);

/// Checks what must hold before the rest of a document is worth reading.
/// in       json   with the right shape, of version 2.x
/// err      asset-version, extension-required by name (G57), too-many (G68)
/// warning  asset-minor-version
void check_capabilities(const JsonNode& json, std::uint32_t max_nodes, IssueLog& log);

}  // namespace sinew
