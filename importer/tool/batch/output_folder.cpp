// SPDX-License-Identifier: MIT
#include "importer/tool/batch/output_folder.h"

#include <filesystem>
#include <map>
#include <set>
#include <system_error>

#include <fmt/core.h>

#include "importer/platform/files.h"

namespace sinew::tool {
namespace fs = std::filesystem;

tl::expected<void, std::string> name_outputs(InputList& list, const std::string& folder, const std::string& extension) {
  std::map<std::string, std::string> input_of;
  std::set<platform::FileIdentity> inputs;
  for (Input& input : list.inputs) {
    if (!input.remark.empty()) continue;
    if (input.path == kStandardInput) return tl::unexpected(std::string("-: has no name for its output"));
    input.output = platform::text_of(
        (platform::path_of(folder) / platform::path_of(input.below)).replace_extension(platform::path_of(extension)));
    const auto [other, fresh] = input_of.try_emplace(input.output, input.path);
    if (!fresh)
      return tl::unexpected(
          fmt::format("{} would be written for {} and for {}", input.output, other->second, input.path));
    if (const auto identity = platform::identity_at(platform::path_of(input.path))) inputs.insert(*identity);
  }
  for (const auto& [output, input] : input_of) {
    if (const auto identity = platform::identity_at(output); identity && inputs.contains(*identity))
      return tl::unexpected(output + " is read; it is left as it is");
    std::error_code error;
    fs::create_directories(platform::path_of(output).parent_path(), error);
    if (error)
      return tl::unexpected(
          fmt::format("{}: {}", platform::text_of(platform::path_of(output).parent_path()), error.message()));
  }
  return {};
}

}  // namespace sinew::tool
