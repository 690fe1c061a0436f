// SPDX-License-Identifier: MIT
#include "importer/import_error.h"

namespace sinew {

std::string describe(std::string_view file, const ImportIssue& issue) {
  std::string line(file);
  line += ": ";
  if (!issue.json_pointer.empty()) line += issue.json_pointer + ": ";
  line += issue.severity == Severity::warning ? "warning: " : "error: ";
  line += issue.rule + ": " + issue.detail;
  return line;
}

}  // namespace sinew
