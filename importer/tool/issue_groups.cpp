// SPDX-License-Identifier: MIT
#include "importer/tool/issue_groups.h"

#include <map>
#include <string_view>
#include <utility>

namespace sinew::tool {

std::string IssueGroup::rule_text() const {
  return cases == 1 ? first->rule : first->rule + " x" + std::to_string(cases);
}

std::vector<IssueGroup> group_issues(std::span<const ImportIssue> issues) {
  std::vector<IssueGroup> groups;
  std::map<std::pair<std::string_view, Severity>, std::size_t> group_of;
  for (const ImportIssue& issue : issues) {
    const auto [found, fresh] = group_of.try_emplace({issue.rule, issue.severity}, groups.size());
    if (fresh) groups.push_back({&issue, 0});
    groups[found->second].cases += issue.cases;
  }
  return groups;
}

}  // namespace sinew::tool
