// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string_view>

namespace sinew {

/// Where programs keep what takes long to compute and never changes: the folder that the environment variable
/// SINEW_CACHE names, else XDG_CACHE_HOME/sinew, else .cache/sinew in the home folder.
/// out  empty = nothing is kept: SINEW_CACHE is "none", or there is no home folder
std::filesystem::path default_cache_folder();

/// The folder that an option names.   in   name  "none" = nothing is kept, "" = the default
std::filesystem::path cache_folder_called(std::string_view name);

}  // namespace sinew
