// SPDX-License-Identifier: MIT
#include "importer/tool/retarget/map_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

#include "importer/platform/files.h"
#include "importer/tool/messages.h"

namespace sinew::tool {
namespace {

using nlohmann::json;
using Applied = tl::expected<void, std::string>;

/// Calls read(joint of the target, text) for each entry of a member of the file; never if the member is absent.
template <class Read>
Applied for_each_joint(const json& map, const char* member, const Skeleton& target, const Read& read) {
  const json entries = map.value(member, json::object());
  if (!entries.is_object()) return tl::unexpected(in_quotes(member) + " is no list of names");
  for (const auto& [name, text] : entries.items()) {
    if (!text.is_string()) return tl::unexpected(in_quotes(name) + " in " + in_quotes(member) + " is no text");
    const auto joint = target.find(name);
    if (!joint) return tl::unexpected("the character has no joint " + in_quotes(name));
    if (auto done = read(*joint, text.template get<std::string>()); !done) return done;
  }
  return {};
}

Applied read_map(const json& map, const Skeleton& source, const Skeleton& target, SkeletonMapOptions& options) {
  for (const auto& [member, value] : map.items())
    if (member != "joints" && member != "translations")
      return tl::unexpected(in_quotes(member) + " is not \"joints\" or \"translations\"");
  auto done = for_each_joint(map, "joints", target, [&](std::uint32_t joint, const std::string& name) -> Applied {
    const auto from = source.find(name);
    if (!from) return tl::unexpected("the clips have no joint " + in_quotes(name));
    options.pairs.push_back({*from, joint});
    return {};
  });
  if (!done) return done;
  return for_each_joint(map, "translations", target, [&](std::uint32_t joint, const std::string& name) -> Applied {
    const auto rule = translation_rule(name);
    if (!rule) return tl::unexpected(in_quotes(name) + " is no rule: hips-by-height, by-length or keep");
    options.chains.push_back({joint, *rule});
    return {};
  });
}

}  // namespace

std::optional<TranslationRule> translation_rule(const std::string& name) {
  const auto found = std::find(std::begin(kTranslationRules), std::end(kTranslationRules), name);
  if (found == std::end(kTranslationRules)) return std::nullopt;
  return static_cast<TranslationRule>(found - std::begin(kTranslationRules));
}

tl::expected<void, std::string> read_map_file(const std::string& file, const Skeleton& source, const Skeleton& target,
                                              SkeletonMapOptions& options) {
  const std::filesystem::path path = platform::path_of(file);
  if (!std::filesystem::is_regular_file(path)) return tl::unexpected(file + ": is no file");
  std::ifstream stream{path};
  const json map = json::parse(stream, nullptr, false);
  if (!map.is_object() || map.empty())
    return tl::unexpected(file + ": is no JSON of the form {\"joints\": {\"TARGET NAME\": \"SOURCE NAME\"}}");
  if (auto done = read_map(map, source, target, options); !done) return tl::unexpected(file + ": " + done.error());
  if (options.pairs.empty() && options.chains.empty()) return tl::unexpected(file + ": pairs no joints");
  return {};
}

}  // namespace sinew::tool
