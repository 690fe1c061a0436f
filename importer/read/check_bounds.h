// SPDX-License-Identifier: MIT
#pragma once
#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// Compares min and max of every accessor that has them with its elements. They are often wrong, and nothing relies on
/// them (G15).
/// in       accessors that have passed check_accessors
/// warning  accessor-bounds
/// cost     O(elements)
void check_bounds(const gltf::Document& document, IssueLog& log);

}  // namespace sinew
