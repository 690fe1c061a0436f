// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "importer/import_error.h"
#include "importer/tool/exit_code.h"

namespace sinew::tool {

/// Prints "sinew: TEXT" to stderr, control characters escaped. Messages go to stderr and results to stdout, so that
/// results can be piped.
void say_error(std::string_view text);

/// "1 clip", "2 clips".
std::string counted(std::size_t count, std::string_view thing);

/// Prints "sinew: FILE: POINTER: RULE: sentence"; warnings have "warning: " before the sentence. The pointer is left
/// out when the whole file is meant.
void say_issue(std::string_view file, const ImportIssue& issue);

/// Prints the message and returns `code`, for a command that ends here.
ExitCode fail_with(ExitCode code, std::string_view text);
ExitCode fail_with(ExitCode code, std::string_view file, const ImportIssue& issue);

/// A name from a file in quotes, with quotes and control characters escaped: terminals obey what they are shown.
std::string in_quotes(std::string_view name);

/// A result as indented JSON, control characters escaped. Bytes of a file that are not UTF-8 are replaced.
std::string json_text(const nlohmann::ordered_json& result);

}  // namespace sinew::tool
