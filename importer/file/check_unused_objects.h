// SPDX-License-Identifier: MIT
#pragma once
#include "importer/file/check_references.h"
#include "importer/file/json_tree.h"

namespace sinew {

/// Finds entries of lists that nothing refers to, and nodes that no scene shows. Members of extensions count as
/// references by their names; of an extension that is not known well, every number counts as one to every list, so that
/// nothing that is used is reported.
/// in    json         the document's tree
///       referenced   as check_references() filled it
/// info  unused-object, node-outside-scenes
/// cost  O(document)
void check_unused_objects(const JsonNode& json, const gltf::Document& document, ReferencedEntries referenced,
                          IssueLog& log);

}  // namespace sinew
