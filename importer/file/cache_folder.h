// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string_view>

namespace sinew {

/// Folder for caches of expensive results: the value of the environment variable SINEW_CACHE. Without it, the folder
/// sinew in XDG_CACHE_HOME, else in .cache of the home folder. On Windows it lies in LOCALAPPDATA.
/// out  empty = no caching: SINEW_CACHE is "none", or there is no such folder
std::filesystem::path default_cache_folder();

/// The folder for the value of a command-line option.   in   name  "none" = no caching, "" = the default
std::filesystem::path cache_folder_called(std::string_view name);

}  // namespace sinew
