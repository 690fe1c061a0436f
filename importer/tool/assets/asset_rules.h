// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "importer/import_error.h"

namespace sinew::tool {

/// Checks an asset file or a file of compiled clips.
/// out   the first broken rule, or an empty list; no value if the file is neither
std::optional<std::vector<ImportIssue>> broken_asset_rules(const std::string& file);

}  // namespace sinew::tool
