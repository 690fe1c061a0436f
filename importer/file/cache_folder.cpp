// SPDX-License-Identifier: MIT
#include "importer/file/cache_folder.h"

#include <cstdlib>

namespace sinew {
namespace {

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

}  // namespace

std::filesystem::path default_cache_folder() {
  if (const std::string_view own = variable("SINEW_CACHE"); !own.empty()) return cache_folder_called(own);
  if (const std::string_view base = variable("XDG_CACHE_HOME"); !base.empty())
    return std::filesystem::path(base) / "sinew";
  const std::string_view home = variable("HOME");
  return home.empty() ? std::filesystem::path() : std::filesystem::path(home) / ".cache" / "sinew";
}

std::filesystem::path cache_folder_called(std::string_view name) {
  if (name.empty()) return default_cache_folder();
  return name == "none" ? std::filesystem::path() : std::filesystem::path(name);
}

}  // namespace sinew
