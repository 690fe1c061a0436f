// SPDX-License-Identifier: MIT
#include "importer/tool/check/check_report.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "importer/tool/issue_groups.h"
#include "importer/tool/messages.h"
#include "importer/visible_text.h"

namespace sinew::tool {
namespace {

constexpr std::array kSeverities = {Severity::error, Severity::warning, Severity::info};

/// Adds "TEXT" or ", TEXT".
void add_part(std::string& list, const std::string& text) { list += (list.empty() ? "" : ", ") + text; }

}  // namespace

CheckReport::CheckReport(std::string file, std::vector<ImportIssue> issues)
    : file_(std::move(file)), issues_(std::move(issues)) {
  std::stable_sort(issues_.begin(), issues_.end(),
                   [](const ImportIssue& a, const ImportIssue& b) { return a.severity < b.severity; });
  for (const ImportIssue& issue : issues_) counts_[static_cast<std::size_t>(issue.severity)] += issue.cases;
}

std::string CheckReport::line(const ImportIssue& issue, const std::string& rule) const {
  return fmt::format("{}: {}{}{}: {}: {}\n", visible_text(file_), visible_text(issue.json_pointer),
                     issue.json_pointer.empty() ? "" : ": ", rule, name_of(issue.severity), visible_text(issue.detail));
}

std::string CheckReport::text(bool all) const {
  std::string out;
  if (all)
    for (const ImportIssue& issue : issues_) out += line(issue, issue.rule);
  else
    for (const IssueGroup& group : group_issues(issues_)) out += line(*group.first, group.rule_text());
  out += fmt::format("{}: {}, {}", visible_text(file_), counted(count(Severity::error), "error"),
                     counted(count(Severity::warning), "warning"));
  if (count(Severity::info) > 0) out += ", " + counted(count(Severity::info), "info");
  return out + '\n';
}

std::string CheckReport::summary() const {
  std::string counts, rules;
  for (const Severity severity : kSeverities)
    if (count(severity) > 0) add_part(counts, counted(count(severity), name_of(severity)));
  for (const IssueGroup& group : group_issues(issues_)) add_part(rules, group.rule_text());
  return fmt::format("{}: {}{}{}\n", visible_text(file_), counts.empty() ? "ok" : counts, rules.empty() ? "" : ": ",
                     rules);
}

Json CheckReport::json() const {
  Json list = Json::array();
  for (const ImportIssue& issue : issues_)
    list.push_back({{"severity", name_of(issue.severity)},
                    {"rule", issue.rule},
                    {"pointer", issue.json_pointer},
                    {"message", issue.detail},
                    {"cases", issue.cases}});
  return {{"file", file_},
          {"errors", count(Severity::error)},
          {"warnings", count(Severity::warning)},
          {"infos", count(Severity::info)},
          {"issues", list}};
}

void CheckTotals::add(const CheckReport& report) {
  const std::lock_guard lock(mutex_);
  for (const Severity severity : kSeverities) counts_[static_cast<std::size_t>(severity)] += report.count(severity);
  for (const ImportIssue& issue : report.issues()) cases_[issue.rule] += issue.cases;
}

std::string CheckTotals::text() const {
  constexpr std::size_t kShown = 3;
  const std::lock_guard lock(mutex_);
  std::string counts, rules;
  for (const Severity severity : kSeverities)
    add_part(counts, counted(counts_[static_cast<std::size_t>(severity)], name_of(severity)));
  std::vector<std::pair<std::string, std::size_t>> often(cases_.begin(), cases_.end());
  std::stable_sort(often.begin(), often.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  for (std::size_t i = 0; i < std::min(often.size(), kShown); ++i)
    add_part(rules, fmt::format("{} x{}", often[i].first, often[i].second));
  return counts + (rules.empty() ? "" : "; most often " + rules);
}

}  // namespace sinew::tool
