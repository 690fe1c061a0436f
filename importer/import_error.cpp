// SPDX-License-Identifier: MIT
#include "importer/import_error.h"

#include "importer/visible_text.h"

namespace sinew {

const char* name_of(Severity severity) noexcept {
  constexpr const char* kNames[] = {"error", "warning", "info"};
  return kNames[static_cast<std::size_t>(severity)];
}

std::string describe(std::string_view file, const ImportIssue& issue) {
  std::string line = visible_text(file);
  line += ": ";
  if (!issue.json_pointer.empty()) line += visible_text(issue.json_pointer) + ": ";
  line += name_of(issue.severity);
  line += ": " + issue.rule + ": " + visible_text(issue.detail);
  return line;
}

}  // namespace sinew
