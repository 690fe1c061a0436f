// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>

#include "importer/import_error.h"

namespace sinew::tool {

/// Messages go to stderr, results to stdout, so that results can be piped.
void say_error(std::string_view text);

/// "sinew: FILE: POINTER: RULE: sentence"; warnings have "warning: " before the sentence. The pointer is left out when
/// the container or the whole file is meant.
void say_issue(std::string_view file, const ImportIssue& issue);

}  // namespace sinew::tool
