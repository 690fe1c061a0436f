// SPDX-License-Identifier: MIT
#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

#include "importer/import_gltf.h"

namespace sinew::tool {

/// Where a command keeps what takes long to compute and never changes: the folder that the environment variable
/// SINEW_CACHE names, else XDG_CACHE_HOME/sinew, else .cache/sinew in the home folder.
/// out  empty = nothing is kept: SINEW_CACHE is "none", or there is no home folder
std::filesystem::path default_cache_folder();

/// Adds --cache DIR to a command. `folder` must outlive its parsing.
void add_cache_option(CLI::App& command, std::string& folder);

/// Asks an import for centers of rotation, which take seconds for a large mesh the first time.
/// in   folder  what --cache said: "" = the default, "none" = nothing is kept
void ask_for_centers(ImportOptions& import, const std::string& folder);

}  // namespace sinew::tool
