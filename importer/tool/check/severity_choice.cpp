// SPDX-License-Identifier: MIT
#include "importer/tool/check/severity_choice.h"

#include <algorithm>
#include <string_view>

#include "importer/rules.h"

namespace sinew::tool {
namespace {

bool is_rule(std::string_view id) {
  const auto rules = all_rules();
  return std::any_of(rules.begin(), rules.end(), [&](const RuleText& rule) { return rule.id == id; });
}

}  // namespace

tl::expected<SeverityChoice, std::string> SeverityChoice::parse(const std::vector<std::string>& texts) {
  SeverityChoice out;
  for (const std::string& text : texts) {
    const auto equals = text.find('=');
    const std::string rule = text.substr(0, equals);
    const std::string word = equals == text.npos ? "" : text.substr(equals + 1);
    if (!is_rule(rule)) return tl::unexpected("--severity " + text + ": there is no rule " + rule + " (see --rules)");
    std::optional<Severity> severity;
    for (const Severity known : {Severity::error, Severity::warning, Severity::info})
      if (word == name_of(known)) severity = known;
    if (!severity && word != "off")
      return tl::unexpected("--severity " + text + ": say " + rule + "=error, =warning, =info or =off");
    out.of_rule_[rule] = severity;
  }
  return out;
}

void SeverityChoice::apply(std::vector<ImportIssue>& issues) const {
  const auto is_off = [&](const ImportIssue& issue) {
    const auto choice = of_rule_.find(issue.rule);
    return choice != of_rule_.end() && !choice->second;
  };
  issues.erase(std::remove_if(issues.begin(), issues.end(), is_off), issues.end());
  for (ImportIssue& issue : issues)
    if (const auto choice = of_rule_.find(issue.rule); choice != of_rule_.end()) issue.severity = *choice->second;
}

}  // namespace sinew::tool
