// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "importer/file/json_tree.h"
#include "importer/issue_log.h"

namespace sinew {

/// False for a file of another generation of glTF, whose version may be a number: no rule of this one applies to it.
/// in   json of any shape; without a version, or with one of another type, the answer is left to its shape
/// err  asset-version
bool check_major_version(const JsonNode& json, IssueLog& log);

/// What must hold before the rest of a document is worth reading.
/// in   json with the right shape, of version 2.x
/// err  asset-version, extension-required by name (G57), too-many (G68);  warning asset-minor-version
void check_capabilities(const JsonNode& json, std::uint32_t max_nodes, IssueLog& log);

}  // namespace sinew
