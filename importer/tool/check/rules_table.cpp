// SPDX-License-Identifier: MIT
#include "importer/tool/check/rules_table.h"

#include <algorithm>
#include <cstddef>

#include <fmt/core.h>

#include "importer/rules.h"
#include "importer/tool/json.h"
#include "importer/tool/messages.h"
#include "importer/tool/wrapped_text.h"

namespace sinew::tool {

std::string rules_text() {
  constexpr std::size_t kSeverity = 9, kConsequence = 22;
  std::size_t widest = 0;
  for (const RuleText& rule : all_rules()) widest = std::max(widest, rule.id.size());
  const std::size_t indent = widest + 2 + kSeverity + kConsequence;
  std::string out;
  for (const RuleText& rule : all_rules())
    out += fmt::format("{:<{}}{:<{}}{:<{}}{}\n", rule.id, widest + 2, name_of(rule.severity), kSeverity,
                       name_of(rule.consequence), kConsequence, wrapped(rule.sentence, indent, indent));
  return out;
}

std::string rules_json() {
  Json rules = Json::array();
  for (const RuleText& rule : all_rules())
    rules.push_back({{"rule", rule.id},
                     {"severity", name_of(rule.severity)},
                     {"consequence", name_of(rule.consequence)},
                     {"sentence", rule.sentence}});
  return json_text(rules) + '\n';
}

}  // namespace sinew::tool
