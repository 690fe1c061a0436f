// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "importer/import_error.h"

namespace sinew::tool {

/// All reports of one rule and severity, shown in one line with the first place.
struct IssueGroup {
  const ImportIssue* first = nullptr;
  std::size_t cases = 0;

  std::string rule_text() const;  ///< "weights-sum", "weights-sum x183"
};

/// Groups reports in the order of their first places.
/// in    issues   must outlive the groups
/// out   cases that the importer did not list are counted
std::vector<IssueGroup> group_issues(std::span<const ImportIssue> issues);

}  // namespace sinew::tool
