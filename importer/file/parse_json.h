// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <memory>
#include <span>

#include "importer/file/json_tree.h"
#include "importer/issue_log.h"

namespace sinew {

inline constexpr std::size_t kMaxJsonDepth = 256;

/// JSON text as a tree. Nesting is bounded, because what handles values later recurses. Numbers are the nearest
/// doubles. out  null after an error; its strings lie in `text`, which must outlive it err  json-syntax with line and
/// column, json-depth;  warning json-bom
std::unique_ptr<JsonTree> parse_json(std::span<const std::byte> text, IssueLog& log);

}  // namespace sinew
