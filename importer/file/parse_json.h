// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <memory>
#include <span>

#include "importer/file/json_reader.h"
#include "importer/file/json_tree.h"
#include "importer/issue_log.h"

namespace sinew {

/// Parses JSON text into a tree. Nesting is limited, because later code is recursive. Numbers become the nearest
/// doubles.
/// out      null after an error. Strings of the tree point into `text`, which must outlive the tree
/// err      json-syntax with line and column, json-depth
/// warning  json-bom
std::unique_ptr<JsonTree> parse_json(std::span<const std::byte> text, IssueLog& log);

}  // namespace sinew
