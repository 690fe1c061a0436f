// SPDX-License-Identifier: MIT
#pragma once
#include "importer/file/json_tree.h"
#include "importer/issue_log.h"

namespace sinew {

/// Checks declarations that the import does not depend on: extension names, offsets without a view, strides of views
/// that must not have one, data URIs. Only a thorough import runs it.
/// in       json   passed check_shape()
/// warning  extension-duplicate, extension-undeclared, accessor-offset, buffer-view-stride, data-uri
/// cost     O(values)
void check_declarations(const JsonNode& json, IssueLog& log);

}  // namespace sinew
