// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "importer/import_error.h"

namespace sinew::tool {

/// What `sinew check` says of an asset file, or of compiled clips: the first rule that it breaks, if any.
/// out   nothing when the file is neither
std::optional<std::vector<ImportIssue>> broken_asset_rules(const std::string& file);

}  // namespace sinew::tool
