// SPDX-License-Identifier: MIT
#include "importer/rules.h"

namespace sinew {
namespace {
constexpr RuleText kRules[] = {
#define SINEW_RULE(name, id, severity, sentence) {id, Severity::severity, sentence},
#include "importer/rules.inc"
#undef SINEW_RULE
};
}  // namespace

const RuleText& describe(Rule rule) noexcept { return kRules[static_cast<std::size_t>(rule)]; }

std::span<const RuleText> all_rules() noexcept { return kRules; }

}  // namespace sinew
