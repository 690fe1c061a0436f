// SPDX-License-Identifier: MIT
#pragma once
#include "importer/file/check_references.h"
#include "importer/file/json_tree.h"

namespace sinew {

/// Finds list entries that nothing refers to, and nodes outside all scenes. Members of known extensions count as
/// references by their names. In unknown extensions, every number counts as a reference to every list, so that no used
/// entry is reported.
/// in    json         the document's tree
///       referenced   as check_references() filled it
/// info  unused-object, node-outside-scenes
/// cost  O(document)
void check_unused_objects(const JsonNode& json, const gltf::Document& document, ReferencedEntries referenced,
                          IssueLog& log);

}  // namespace sinew
