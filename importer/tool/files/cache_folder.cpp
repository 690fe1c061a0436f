// SPDX-License-Identifier: MIT
#include "importer/tool/files/cache_folder.h"

#include <cstdlib>
#include <string_view>

namespace sinew::tool {
namespace {

constexpr const char* kNoCache = "none";

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

std::filesystem::path folder_called(std::string_view name) { return name == kNoCache ? std::string_view() : name; }

}  // namespace

std::filesystem::path default_cache_folder() {
  if (const std::string_view own = variable("SINEW_CACHE"); !own.empty()) return folder_called(own);
  if (const std::string_view base = variable("XDG_CACHE_HOME"); !base.empty())
    return std::filesystem::path(base) / "sinew";
  const std::string_view home = variable("HOME");
  return home.empty() ? std::filesystem::path() : std::filesystem::path(home) / ".cache" / "sinew";
}

void add_cache_option(CLI::App& command, std::string& folder) {
  command
      .add_option("--cache", folder,
                  "Where centers of rotation are kept for the next run; none = nowhere (default: the environment "
                  "variable SINEW_CACHE, else sinew in the user's cache folder)")
      ->type_name("DIR|none");
}

void ask_for_centers(ImportOptions& import, const std::string& folder) {
  import.make_centers_of_rotation = true;
  import.centers_cache = folder.empty() ? default_cache_folder() : folder_called(folder);
}

}  // namespace sinew::tool
