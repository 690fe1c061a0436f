// SPDX-License-Identifier: MIT
#include "importer/file/cache_folder.h"

#include <string>

#include "importer/platform/files.h"
#include "importer/platform/program.h"

namespace sinew {

std::filesystem::path default_cache_folder() {
  if (const std::string own = platform::environment_variable("SINEW_CACHE"); !own.empty())
    return cache_folder_called(own);
  const std::filesystem::path folder = platform::user_cache_folder();
  return folder.empty() ? folder : folder / "sinew";
}

std::filesystem::path cache_folder_called(std::string_view name) {
  if (name.empty()) return default_cache_folder();
  return name == "none" ? std::filesystem::path() : platform::path_of(name);
}

}  // namespace sinew
