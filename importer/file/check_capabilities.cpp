// SPDX-License-Identifier: MIT
#include "importer/file/check_capabilities.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

#include "importer/file/json_pointer.h"
#include "importer/read/accessor.h"

namespace sinew {
namespace {

using gltf::Json;

constexpr std::string_view kSupported[] = {
    "KHR_animation_pointer", "KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_unlit",
    "KHR_mesh_quantization", "KHR_texture_transform",
};

struct Version {
  int major = 0, minor = 0;
};

std::optional<Version> parse_version(const std::string& text) {
  Version version;
  const char *begin = text.data(), *end = begin + text.size();
  const auto major = std::from_chars(begin, end, version.major);
  if (major.ec != std::errc() || major.ptr == end || *major.ptr != '.') return std::nullopt;
  const auto minor = std::from_chars(major.ptr + 1, end, version.minor);
  if (minor.ec != std::errc() || minor.ptr != end) return std::nullopt;
  return version;
}

void check_version(const Json& asset, IssueLog& log) {
  const std::string text = asset["version"].get<std::string>();
  const auto version = parse_version(text);
  if (!version || version->major != 2)
    return log.report(Rule::asset_version, "/asset/version", "\"" + text.substr(0, 40) + "\" is not 2.x");
  if (const auto required = asset.find("minVersion"); required != asset.end()) {
    const auto minimum = parse_version(required->get<std::string>());
    if (!minimum || minimum->major != 2 || minimum->minor > 0)
      return log.report(Rule::asset_version, "/asset/minVersion", required->dump().substr(0, 40) + " is above 2.0");
  }
  if (version->minor > 0)
    log.report(Rule::asset_minor_version, "/asset/version", "\"" + text.substr(0, 40) + "\" is read as 2.0");
}

void check_list_sizes(const Json& json, std::uint32_t max_nodes, IssueLog& log) {
  constexpr std::size_t kMaxSmallList = 65536;
  constexpr std::string_view kLarge[] = {"accessors", "bufferViews", "meshes", "nodes"};
  for (const auto& [name, list] : json.items()) {
    if (!list.is_array()) continue;
    const bool large = std::find(std::begin(kLarge), std::end(kLarge), name) != std::end(kLarge);
    const std::size_t most = large ? max_nodes : std::min<std::size_t>(max_nodes, kMaxSmallList);
    if (list.size() > most)
      log.report(Rule::too_many, pointer(name), std::to_string(list.size()) + " entries, at most " + std::to_string(most) + " are allowed");
  }
}

class Budget {
 public:
  explicit Budget(const gltf::Document& document) : document_(document) {}

  /// As floats, which is what attributes become.
  void add(std::uint32_t accessor, std::uint64_t times = 1) {
    if (accessor == kNone) return;
    const auto& source = document_.accessors[accessor];
    const std::uint64_t count = std::min(source.count, kHuge);
    total_ = std::min(kHuge, total_ + count * element_layout(source).components() * 4 * times);
  }

  std::uint64_t total() const noexcept { return total_; }

 private:
  static constexpr std::uint64_t kHuge = std::uint64_t{1} << 48;
  const gltf::Document& document_;
  std::uint64_t total_ = 0;
};

}  // namespace

std::span<const std::string_view> supported_extensions() noexcept { return kSupported; }

void check_capabilities(const Json& json, std::uint32_t max_nodes, IssueLog& log) {
  check_version(json["asset"], log);
  if (const auto required = json.find("extensionsRequired"); required != json.end())
    for (std::size_t i = 0; i < required->size(); ++i) {
      const auto name = (*required)[i].get<std::string>();
      if (std::find(std::begin(kSupported), std::end(kSupported), name) == std::end(kSupported))
        log.report(Rule::extension_required, pointer("extensionsRequired", i), "\"" + name.substr(0, 80) + "\" is not supported");
    }
  check_list_sizes(json, max_nodes, log);
}

void check_memory_budget(const gltf::Document& document, std::uint64_t file_bytes, IssueLog& log) {
  constexpr std::uint64_t kFree = std::uint64_t{64} << 20;
  constexpr std::uint64_t kPerByte = 64;
  Budget budget(document);
  for (const auto& mesh : document.meshes)
    for (const auto& primitive : mesh.primitives) {
      for (const auto& [name, accessor] : primitive.attributes) budget.add(accessor);
      for (const auto& target : primitive.targets)
        for (const auto& [name, accessor] : target.attributes) budget.add(accessor);
      budget.add(primitive.indices, 3);  // a strip unrolls to three times its length
    }
  for (const auto& animation : document.animations)
    for (const auto& channel : animation.channels) {
      budget.add(animation.samplers[channel.sampler].input);
      budget.add(animation.samplers[channel.sampler].output);
    }
  for (const auto& skin : document.skins) budget.add(skin.inverse_bind_matrices);
  const std::uint64_t allowed = kFree + kPerByte * std::min(file_bytes, std::uint64_t{1} << 40);
  if (budget.total() > allowed)
    log.report(Rule::memory_budget, "", "vertices and keys would take " + std::to_string(budget.total()) + " bytes, a file of " +
                                            std::to_string(file_bytes) + " bytes may take " + std::to_string(allowed));
}

}  // namespace sinew
