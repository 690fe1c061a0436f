// SPDX-License-Identifier: MIT
#include "importer/import_error.h"

#include "importer/visible_text.h"

namespace sinew {

std::string describe(std::string_view file, const ImportIssue& issue) {
  std::string line = visible_text(file);
  line += ": ";
  if (!issue.json_pointer.empty()) line += visible_text(issue.json_pointer) + ": ";
  line += issue.severity == Severity::warning ? "warning: " : "error: ";
  line += issue.rule + ": " + visible_text(issue.detail);
  return line;
}

}  // namespace sinew
