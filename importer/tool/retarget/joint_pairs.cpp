// SPDX-License-Identifier: MIT
#include "importer/tool/retarget/joint_pairs.h"

#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

#include "importer/tool/messages.h"

namespace sinew::tool {

tl::expected<std::vector<std::array<std::uint32_t, 2>>, std::string> read_joint_pairs(const std::string& file,
                                                                                      const Skeleton& source,
                                                                                      const Skeleton& target) {
  if (!std::filesystem::is_regular_file(file)) return tl::unexpected(file + ": is no file");
  std::ifstream stream(file);
  const nlohmann::json map = nlohmann::json::parse(stream, nullptr, false);
  if (!map.is_object() || !map.contains("joints") || !map["joints"].is_object())
    return tl::unexpected(file + ": is no JSON of the form {\"joints\": {\"TARGET NAME\": \"SOURCE NAME\"}}");
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (const auto& [name, other] : map["joints"].items()) {
    if (!other.is_string()) return tl::unexpected(file + ": " + in_quotes(name) + " names no joint");
    const auto to = target.find(name), from = source.find(other.get<std::string>());
    if (!to) return tl::unexpected(file + ": the character has no joint " + in_quotes(name));
    if (!from) return tl::unexpected(file + ": the clips have no joint " + in_quotes(other.get<std::string>()));
    pairs.push_back({*from, *to});
  }
  if (pairs.empty()) return tl::unexpected(file + ": pairs no joints");
  return pairs;
}

}  // namespace sinew::tool
