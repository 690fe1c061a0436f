// SPDX-License-Identifier: MIT
#pragma once
#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// Compares declared min and max of accessors with their elements. They are often wrong, so nothing relies on them.
/// in       accessors passed check_accessors()
/// warning  accessor-bounds
/// cost     O(elements)
void check_bounds(const gltf::Document& document, IssueLog& log);

}  // namespace sinew
