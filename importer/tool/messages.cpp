// SPDX-License-Identifier: MIT
#include "importer/tool/messages.h"

#include <algorithm>
#include <cstdio>
#include <sstream>

#include <fmt/core.h>

#include "importer/tool/batch/captured_output.h"
#include "importer/tool/issue_groups.h"
#include "importer/tool/json.h"
#include "importer/visible_text.h"

namespace sinew::tool {
namespace {

thread_local bool results_to_stderr = false;

void print_message(const std::string& line) {
  if (CapturedOutput* kept = CapturedOutput::current())
    kept->messages += "sinew: " + line + '\n';
  else
    fmt::print(stderr, "sinew: {}\n", line);
}

/// Escapes all lines of a text, except that line ends stay. Names of files and folders may contain any character.
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

void print_rule(std::string_view file, const ImportIssue& issue, std::string_view rule) {
  const std::string severity = issue.severity == Severity::error ? "" : std::string(name_of(issue.severity)) + ": ";
  print_message(fmt::format("{}: {}{}{}: {}{}", visible_text(file), visible_text(issue.json_pointer),
                            issue.json_pointer.empty() ? "" : ": ", rule, severity, visible_text(issue.detail)));
}

}  // namespace

ResultsToStderr::ResultsToStderr(bool active) : before_(results_to_stderr) { results_to_stderr = active; }
ResultsToStderr::~ResultsToStderr() { results_to_stderr = before_; }

void print_result_text(std::string_view text) {
  const std::string shown = visible_lines(text);
  if (results_to_stderr) {
    std::istringstream lines(shown);
    for (std::string line; std::getline(lines, line);) print_message(line);
    return;
  }
  if (CapturedOutput* kept = CapturedOutput::current())
    kept->results += shown;
  else
    std::fwrite(shown.data(), 1, shown.size(), stdout);
}

void print_error(std::string_view text) { print_message(visible_text(text)); }

std::string counted(std::size_t count, std::string_view thing) {
  const char* plural = thing.ends_with("sh") ? "es" : "s";
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : plural);
}

std::string size_text(double bytes) {
  if (bytes < 10'000) return fmt::format("{:.0f} B", bytes);
  if (bytes < 10'000'000) return fmt::format("{:.1f} kB", bytes / 1e3);
  return fmt::format("{:.1f} MB", bytes / 1e6);
}

void print_issue(std::string_view file, const ImportIssue& issue) { print_rule(file, issue, issue.rule); }

void print_issues(std::string_view file, std::span<const ImportIssue> issues) {
  for (const IssueGroup& group : group_issues(issues)) print_rule(file, *group.first, group.rule_text());
}

ExitCode fail_with(ExitCode code, std::string_view text) {
  print_error(text);
  return code;
}

ExitCode fail_with(ExitCode code, std::string_view file, const ImportIssue& issue) {
  print_issue(file, issue);
  return code;
}

std::string in_quotes(std::string_view name) { return visible_json(Json(name).dump()); }

std::string json_text(const Json& result) { return visible_json(result.dump(2)); }

std::string json_line(const Json& result) { return visible_json(result.dump()) + '\n'; }

void print_json(const Json& result, bool many) {
  print_result_text(many ? json_line(result) : json_text(result) + '\n');
}

}  // namespace sinew::tool
