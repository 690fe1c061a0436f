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
  std::size_t widest = 0;
  for (const RuleText& rule : all_rules()) widest = std::max(widest, rule.id.size());
  std::string out;
  for (const RuleText& rule : all_rules())
    out += fmt::format("{:<{}}  {:<7}  {}\n", rule.id, widest, name_of(rule.severity),
                       wrapped(rule.sentence, widest + 11, widest + 11));
  return out;
}

std::string rules_json() {
  Json rules = Json::array();
  for (const RuleText& rule : all_rules())
    rules.push_back({{"rule", rule.id}, {"severity", name_of(rule.severity)}, {"sentence", rule.sentence}});
  return json_text(rules) + '\n';
}

}  // namespace sinew::tool
