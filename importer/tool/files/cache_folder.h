// SPDX-License-Identifier: MIT
#pragma once
#include <CLI/CLI.hpp>
#include <string>

#include "importer/import_gltf.h"

namespace sinew::tool {

/// Adds --cache DIR to a command. `folder` must outlive its parsing.
void add_cache_option(CLI::App& command, std::string& folder);

/// Asks an import for centers of rotation, which take seconds for a large mesh the first time.
/// in   folder  what --cache said: "" = the default, "none" = nothing is kept
void ask_for_centers(ImportOptions& import, const std::string& folder);

}  // namespace sinew::tool
