// SPDX-License-Identifier: MIT
#pragma once
#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// Proves that every index of the document names an existing entry and that the nodes form a forest, so that later code
/// can index without checks (T1, G55). It does not recurse, so deep trees are no problem.
/// err      reference, node-parents, node-cycle
/// warning  scene-root, accessor-empty
/// cost     O(document)
void check_references(const gltf::Document& document, IssueLog& log);

}  // namespace sinew
