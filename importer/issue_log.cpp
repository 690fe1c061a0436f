// SPDX-License-Identifier: MIT
#include "importer/issue_log.h"

#include <utility>

namespace sinew {

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 80;
  std::string out(1, '"');
  out += text.substr(0, kLongest);
  out += text.size() > kLongest ? "...\"" : "\"";
  return out;
}

void IssueLog::report(Rule rule, std::string json_pointer, std::string detail) {
  const RuleText& text = describe(rule);
  if (text.severity == Severity::error) ++error_count_;
  seen_.resize(all_rules().size(), 0);
  const std::size_t seen = ++seen_[static_cast<std::size_t>(rule)];
  if (seen > kMaxPerRule) return;
  if (seen == kMaxPerRule) detail += " (further cases of this rule are not listed)";
  issues_.push_back({text.severity, std::string(text.id), std::move(json_pointer), std::move(detail)});
}

std::vector<ImportIssue> IssueLog::take_warnings() { return std::exchange(issues_, {}); }

ImportError IssueLog::take_error(std::string file) {
  ImportError error;
  error.file = std::move(file);
  bool first = true;
  for (auto& issue : issues_) {
    if (issue.severity == Severity::warning)
      error.warnings.push_back(std::move(issue));
    else if (std::exchange(first, false))
      error.issue = std::move(issue);
    else
      error.more_errors.push_back(std::move(issue));
  }
  issues_.clear();
  return error;
}

}  // namespace sinew
