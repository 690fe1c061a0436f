// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "importer/import_error.h"
#include "importer/tool/exit_code.h"

namespace sinew::tool {

class Json;

/// Prints "sinew: TEXT" to stderr, control characters escaped. Messages go to stderr and results to stdout, so that
/// results can be piped.
void print_error(std::string_view text);

/// Prints lines of a result to stdout, control characters escaped: files and folders may have any name. Commands that
/// take several files print only with this function and those below. Jobs run side by side, and the output of each is
/// kept until its turn (batch/captured_output.h).
void print_result_text(std::string_view text);

template <class... Args>
void print_result(fmt::format_string<Args...> format, Args&&... args) {
  print_result_text(fmt::format(format, std::forward<Args>(args)...));
}

/// While an object of this class lives, results of its thread go to stderr, since stdout gets the output of the
/// command.
class ResultsToStderr {
 public:
  explicit ResultsToStderr(bool active);
  ~ResultsToStderr();
  ResultsToStderr(const ResultsToStderr&) = delete;
  ResultsToStderr& operator=(const ResultsToStderr&) = delete;

 private:
  bool before_;
};

/// "1 clip", "2 clips", "2 meshes".
std::string counted(std::size_t count, std::string_view thing);

/// "120 B", "1.5 kB", "20.1 MB".
std::string size_text(double bytes);

/// Prints "sinew: FILE: POINTER: RULE: sentence"; warnings have "warning: " before the sentence. Issues about the whole
/// file have no pointer.
void print_issue(std::string_view file, const ImportIssue& issue);

/// Prints one line for each rule, with the number of its cases and the first of them.
void print_issues(std::string_view file, std::span<const ImportIssue> issues);

/// Prints the message and returns `code`, for a command that ends here.
ExitCode fail_with(ExitCode code, std::string_view text);
ExitCode fail_with(ExitCode code, std::string_view file, const ImportIssue& issue);

/// A name from a file in quotes, with quotes and control characters escaped: terminals obey what they are shown.
std::string in_quotes(std::string_view name);

/// A result as indented JSON, control characters escaped. Bytes of a file that are not UTF-8 are replaced.
std::string json_text(const Json& result);

/// The same in one line, with its end.
std::string json_line(const Json& result);

/// Prints a result as JSON: indented, or in one line if it is one of many.
void print_json(const Json& result, bool many);

}  // namespace sinew::tool
