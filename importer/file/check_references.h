// SPDX-License-Identifier: MIT
#pragma once
#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// Proves that every index of the document points at something and that the nodes form a forest, so that all later code
/// indexes without asking (T1, G55). Iterative: depth is no limit.
/// err  reference, node-parents, node-cycle;  warning scene-root, accessor-empty.   cost O(document)
void check_references(const gltf::Document& document, IssueLog& log);

}  // namespace sinew
