// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "importer/import_error.h"

namespace sinew::tool {

/// Prints "sinew: TEXT" to stderr. Messages go to stderr and results to stdout, so that results can be piped.
void say_error(std::string_view text);

/// "1 clip", "2 clips".
std::string counted(std::size_t count, std::string_view thing);

/// Prints "sinew: FILE: POINTER: RULE: sentence"; warnings have "warning: " before the sentence. The pointer is left
/// out when the whole file is meant.
void say_issue(std::string_view file, const ImportIssue& issue);

}  // namespace sinew::tool
