// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <span>

#include <nlohmann/json.hpp>

#include "importer/issue_log.h"

namespace sinew {

inline constexpr std::size_t kMaxJsonDepth = 256;

/// JSON text to a value. Nesting is bounded first, because what handles values later recurses.
/// err  json-syntax with line and column, json-depth;  warning json-bom
std::optional<nlohmann::json> parse_json(std::span<const std::byte> text, IssueLog& log);

}  // namespace sinew
