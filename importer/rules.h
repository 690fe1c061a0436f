// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include "importer/import_error.h"

namespace sinew {

/// Every rule that the importer checks. The table in rules.inc gives each rule a stable identifier, a severity and one
/// sentence that says what holds in a correct file; for a warning the sentence also says which repair is made.
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
