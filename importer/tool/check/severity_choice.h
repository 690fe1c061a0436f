// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "importer/import_error.h"

namespace sinew::tool {

/// Severities of rules that the user changes with --severity.
class SeverityChoice {
 public:
  /// Reads the values of --severity.
  /// in    texts   "weights-sum=error", "unused-object=off"; if several name one rule, the last counts
  /// err   a sentence for the user, if there is no such rule or no such severity
  static tl::expected<SeverityChoice, std::string> parse(const std::vector<std::string>& texts);

  /// Gives reports their severity, and leaves out those that are off.
  void apply(std::vector<ImportIssue>& issues) const;

 private:
  std::map<std::string, std::optional<Severity>, std::less<>> of_rule_;  ///< empty = off
};

}  // namespace sinew::tool
