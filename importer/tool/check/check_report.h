// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "importer/import_error.h"
#include "importer/tool/json.h"

namespace sinew::tool {

/// The issues of one file: errors first, then warnings, then infos.
class CheckReport {
 public:
  CheckReport(std::string file, std::vector<ImportIssue> issues);

  std::size_t count(Severity severity) const { return counts_[static_cast<std::size_t>(severity)]; }
  const std::vector<ImportIssue>& issues() const { return issues_; }

  /// One line for each rule, or with `all` for each place; then the counts.
  std::string text(bool all) const;

  /// One line: "ok", or counts and rules.
  std::string summary() const;

  Json json() const;

 private:
  std::string line(const ImportIssue& issue, const std::string& rule) const;

  std::string file_;
  std::vector<ImportIssue> issues_;
  std::array<std::size_t, 3> counts_{};  ///< number of issues of each severity
};

/// Counts over many files. Any thread may add.
class CheckTotals {
 public:
  void add(const CheckReport& report);

  /// "5 errors, 7 warnings, 0 infos; most often weights-sum x5, mesh-index x2"
  std::string text() const;

 private:
  mutable std::mutex mutex_;
  std::array<std::size_t, 3> counts_{};
  std::map<std::string, std::size_t> cases_;  ///< number of issues of each rule
};

}  // namespace sinew::tool
