// SPDX-License-Identifier: MIT
#include "importer/tool/messages.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "importer/tool/batch/captured_output.h"
#include "importer/tool/issue_groups.h"
#include "importer/visible_text.h"

namespace sinew::tool {
namespace {

void say_line(const std::string& line) {
  if (CapturedOutput* kept = CapturedOutput::current())
    kept->messages += "sinew: " + line + '\n';
  else
    fmt::print(stderr, "sinew: {}\n", line);
}

/// Lines, in which names of files and folders may stand as they are.
std::string visible_lines(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    out += visible_text(text.substr(0, end));
    if (end < text.size()) out += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

void say_rule(std::string_view file, const ImportIssue& issue, std::string_view rule) {
  const std::string severity = issue.severity == Severity::error ? "" : std::string(name_of(issue.severity)) + ": ";
  say_line(fmt::format("{}: {}{}{}: {}{}", visible_text(file), visible_text(issue.json_pointer),
                       issue.json_pointer.empty() ? "" : ": ", rule, severity, visible_text(issue.detail)));
}

}  // namespace

void print_result_text(std::string_view text) {
  const std::string shown = visible_lines(text);
  if (CapturedOutput* kept = CapturedOutput::current())
    kept->results += shown;
  else
    std::fwrite(shown.data(), 1, shown.size(), stdout);
}

void say_error(std::string_view text) { say_line(visible_text(text)); }

std::string counted(std::size_t count, std::string_view thing) {
  const char* plural = thing.ends_with("sh") ? "es" : "s";
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : plural);
}

std::string size_text(double bytes) {
  if (bytes < 10'000) return fmt::format("{:.0f} B", bytes);
  if (bytes < 10'000'000) return fmt::format("{:.1f} kB", bytes / 1e3);
  return fmt::format("{:.1f} MB", bytes / 1e6);
}

void say_issue(std::string_view file, const ImportIssue& issue) { say_rule(file, issue, issue.rule); }

void say_issues(std::string_view file, std::span<const ImportIssue> issues) {
  for (const IssueGroup& group : group_issues(issues)) say_rule(file, *group.first, group.rule_text());
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

std::string json_line(const nlohmann::ordered_json& result) {
  return visible_json(result.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)) + '\n';
}

}  // namespace sinew::tool
