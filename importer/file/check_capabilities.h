// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "importer/file/json_tree.h"
#include "importer/issue_log.h"

namespace sinew {

/// Returns false for JSON that has nothing of glTF: neither `asset` nor any list. Servers send such JSON as an error.
/// in    json   unchecked JSON; anything but an object with members is left to check_shape()
/// err   not-gltf
bool check_is_gltf(const JsonNode& json, IssueLog& log);

/// Returns false for another major version of glTF, to which no other rule applies.
/// in    json   unchecked JSON; a missing or mistyped version is left to check_shape()
/// err   asset-version
bool check_major_version(const JsonNode& json, IssueLog& log);

/// Checks version, required extensions and list sizes, before the rest of the document is read.
/// in       json   passed check_shape(); version 2.x
/// err      asset-version, extension-required (with its name), too-many
/// warning  asset-minor-version
void check_capabilities(const JsonNode& json, std::uint32_t max_nodes, IssueLog& log);

}  // namespace sinew
