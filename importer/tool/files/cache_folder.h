// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "importer/import_gltf.h"
#include "importer/tool/command.h"

namespace sinew::tool {

/// Adds --cache DIR to a command. `folder` must live as long as the command.
void add_cache_option(Command& command, std::string& folder);

/// Asks an import for centers of rotation, which take seconds for a large mesh the first time.
/// in   folder  value of --cache: "" = the default, "none" = nothing is kept
void request_centers(ImportOptions& import, const std::string& folder);

}  // namespace sinew::tool
