// SPDX-License-Identifier: MIT
#include "importer/tool/messages.h"

#include <cstdio>

#include <fmt/format.h>

namespace sinew::tool {

void say_error(std::string_view text) { fmt::print(stderr, "sinew: {}\n", text); }

std::string counted(std::size_t count, std::string_view thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

void say_issue(std::string_view file, const ImportIssue& issue) {
  fmt::print(stderr, "sinew: {}: {}{}{}: {}{}\n", file, issue.json_pointer, issue.json_pointer.empty() ? "" : ": ",
             issue.rule, issue.severity == Severity::warning ? "warning: " : "", issue.detail);
}

}  // namespace sinew::tool
