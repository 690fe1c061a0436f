// SPDX-License-Identifier: MIT
#pragma once
#include "importer/file/json_tree.h"
#include "importer/issue_log.h"

namespace sinew {

/// Finds what is wrong in parts of a document that the rest of the import never misses: names of extensions, offsets
/// without a view, strides on views that take none, data URIs. Run by a thorough import only.
/// in       json   with the right shape
/// warning  extension-duplicate, extension-undeclared, accessor-offset, buffer-view-stride, data-uri
/// cost     O(values)
void check_declarations(const JsonNode& json, IssueLog& log);

}  // namespace sinew
