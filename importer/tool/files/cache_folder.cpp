// SPDX-License-Identifier: MIT
#include "importer/tool/files/cache_folder.h"

#include "importer/file/cache_folder.h"

namespace sinew::tool {

void add_cache_option(Command& command, std::string& folder) {
  command.option("--cache", "DIR|none", &folder,
                 "Where centers of rotation are kept for the next run; none = nowhere (default: the environment "
                 "variable SINEW_CACHE, else sinew in the user's cache folder)");
}

void request_centers(ImportOptions& import, const std::string& folder) {
  import.make_centers_of_rotation = true;
  import.centers_cache = cache_folder_called(folder);
}

}  // namespace sinew::tool
