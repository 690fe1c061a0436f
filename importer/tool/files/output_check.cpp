// SPDX-License-Identifier: MIT
#include "importer/tool/files/output_check.h"

#include <algorithm>
#include <system_error>

namespace sinew::tool {
namespace fs = std::filesystem;

std::optional<std::string> check_output_path(const fs::path& output, std::span<const fs::path> inputs) {
  std::error_code error;
  const auto is_output = [&](const fs::path& input) { return fs::equivalent(input, output, error); };
  if (std::any_of(inputs.begin(), inputs.end(), is_output)) return output.string() + " is read; it is left as it is";
  if (fs::exists(output, error) && !fs::is_regular_file(output, error))
    return output.string() + " exists and is not a regular file";
  const fs::path folder = output.has_parent_path() ? output.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) return "there is no folder " + folder.string();
  return std::nullopt;
}

}  // namespace sinew::tool
