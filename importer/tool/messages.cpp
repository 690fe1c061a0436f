// SPDX-License-Identifier: MIT
#include "importer/tool/messages.h"

#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "importer/visible_text.h"

namespace sinew::tool {

void say_error(std::string_view text) { fmt::print(stderr, "sinew: {}\n", visible_text(text)); }

std::string counted(std::size_t count, std::string_view thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

void say_issue(std::string_view file, const ImportIssue& issue) {
  fmt::print(stderr, "sinew: {}: {}{}{}: {}{}\n", visible_text(file), visible_text(issue.json_pointer),
             issue.json_pointer.empty() ? "" : ": ", issue.rule, issue.severity == Severity::warning ? "warning: " : "",
             visible_text(issue.detail));
}

ExitCode fail_with(ExitCode code, std::string_view text) {
  say_error(text);
  return code;
}

ExitCode fail_with(ExitCode code, std::string_view file, const ImportIssue& issue) {
  say_issue(file, issue);
  return code;
}

std::string in_quotes(std::string_view name) {
  return visible_json(nlohmann::json(name).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

std::string json_text(const nlohmann::ordered_json& result) {
  return visible_json(result.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace sinew::tool
