// SPDX-License-Identifier: MIT
#include "importer/rules.h"

#include <cstddef>

namespace sinew {
namespace {
constexpr RuleText kRules[] = {
#define SINEW_RULE(name, id, severity, consequence, sentence) \
  {id, Severity::severity, Consequence::consequence, sentence},
#include "importer/rules.inc"
#undef SINEW_RULE
};
}  // namespace

std::string_view name_of(Consequence consequence) noexcept {
  constexpr std::string_view kNames[] = {
      "refused", "refused or left out", "left out", "repaired or left out", "repaired", "named"};
  return kNames[static_cast<std::size_t>(consequence)];
}

const RuleText& describe(Rule rule) noexcept { return kRules[static_cast<std::size_t>(rule)]; }

std::span<const RuleText> all_rules() noexcept { return kRules; }

}  // namespace sinew
