// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include "importer/import_error.h"

namespace sinew {

/// All rules that the importer checks. rules.inc gives each a stable identifier, a severity, and a sentence that is
/// true for correct files. For a warning, the sentence also names the repair.
enum class Rule : std::uint8_t {
#define SINEW_RULE(name, id, severity, sentence) name,
#include "importer/rules.inc"
#undef SINEW_RULE
};

struct RuleText {
  std::string_view id;
  Severity severity = Severity::error;
  std::string_view sentence;
};

const RuleText& describe(Rule rule) noexcept;

/// All rules, in the order of the enumeration.
std::span<const RuleText> all_rules() noexcept;

}  // namespace sinew
