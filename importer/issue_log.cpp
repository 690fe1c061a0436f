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
  const Severity severity = describe(rule).severity;
  add(severity, severity == Severity::error, rule, std::move(json_pointer), std::move(detail));
}

void IssueLog::report_as_warning(Rule rule, std::string json_pointer, std::string detail) {
  add(Severity::warning, false, rule, std::move(json_pointer), std::move(detail));
}

void IssueLog::report_survived(Rule rule, std::string json_pointer, std::string detail) {
  add(Severity::error, false, rule, std::move(json_pointer), std::move(detail));
}

void IssueLog::survive(const std::function<std::string(std::string_view)>& consequence) {
  for (Entry& entry : issues_)
    if (std::exchange(entry.fatal, false)) entry.issue.detail += consequence(entry.issue.json_pointer);
  error_count_ = settled_ = 0;
}

void IssueLog::add(Severity severity, bool fatal, Rule rule, std::string json_pointer, std::string detail) {
  const bool muted = is_muted(json_pointer);
  if (fatal) {
    ++error_count_;
    if (fresh_places_.size() < kMaxPlaces && rule != Rule::memory_budget)
      fresh_places_.push_back(json_pointer);
    else
      has_no_place_ = true;
  }
  if (muted) return;
  tallies_.resize(all_rules().size());
  Tally& tally = tallies_[static_cast<std::size_t>(rule)][static_cast<std::size_t>(severity)];
  if (tally.listed >= listed_) {
    ++issues_[tally.last].issue.cases;
    issues_[tally.last].fatal |= fatal;
    return;
  }
  ++tally.listed;
  tally.last = issues_.size();
  issues_.push_back({{severity, std::string(describe(rule).id), std::move(json_pointer), std::move(detail)}, fatal});
}

void IssueLog::name_unlisted() {
  for (auto& [issue, fatal] : issues_)
    if (issue.cases > 1) issue.detail += " (" + std::to_string(issue.cases - 1) + " more of this rule are not listed)";
}

bool IssueLog::is_muted(std::string_view json_pointer) const {
  for (auto end = json_pointer.size(); !muted_.empty() && end != json_pointer.npos && end > 0;
       end = json_pointer.rfind('/', end - 1))
    if (muted_.contains(json_pointer.substr(0, end))) return true;
  return false;
}

std::optional<std::vector<std::string>> IssueLog::settle() {
  settled_ = error_count_;
  if (has_no_place_) return std::nullopt;
  return std::exchange(fresh_places_, {});
}

std::vector<ImportIssue> IssueLog::take_warnings() {
  name_unlisted();
  tallies_.clear();
  std::vector<ImportIssue> out;
  for (auto& [issue, fatal] : issues_) out.push_back(std::move(issue));
  issues_.clear();
  return out;
}

ImportError IssueLog::take_error(std::string file) {
  name_unlisted();
  tallies_.clear();
  ImportError error;
  error.file = std::move(file);
  bool first = true;
  for (auto& [issue, fatal] : issues_) {
    if (issue.severity != Severity::error)
      error.warnings.push_back(std::move(issue));
    else if (fatal && std::exchange(first, false))
      error.issue = std::move(issue);
    else
      error.more_errors.push_back(std::move(issue));
  }
  issues_.clear();
  if (first && !error.more_errors.empty()) {  // fatal errors are muted: they follow from survived ones
    error.issue = std::move(error.more_errors.front());
    error.more_errors.erase(error.more_errors.begin());
  }
  return error;
}

}  // namespace sinew
