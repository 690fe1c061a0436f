// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include "importer/import_error.h"

namespace sinew {

/// All rules that the importer checks. rules.inc gives each a stable identifier, a severity, a consequence, and a
/// sentence that is true for correct files and names the repair of others.
enum class Rule : std::uint8_t {
#define SINEW_RULE(name, id, severity, consequence, sentence) name,
#include "importer/rules.inc"
#undef SINEW_RULE
};

/// The fate of a file that breaks a rule.
/// - refused: the import fails.
/// - refused_or_left_out: if only animation channels need the broken part, they are left out; else the import fails.
/// - left_out: the scene is made without the broken part.
/// - repaired_or_left_out: the part is repaired if that takes no guess, else left out.
/// - repaired: other values are used, as the sentence of the rule says.
/// - named: the file is read as it is.
enum class Consequence : std::uint8_t { refused, refused_or_left_out, left_out, repaired_or_left_out, repaired, named };

/// "refused", "refused or left out", ...
std::string_view name_of(Consequence consequence) noexcept;

struct RuleText {
  std::string_view id;
  Severity severity = Severity::error;
  Consequence consequence = Consequence::refused;
  std::string_view sentence;
};

const RuleText& describe(Rule rule) noexcept;

/// All rules, in the order of the enumeration.
std::span<const RuleText> all_rules() noexcept;

}  // namespace sinew
