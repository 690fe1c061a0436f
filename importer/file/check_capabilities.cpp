// SPDX-License-Identifier: MIT
#include "importer/file/check_capabilities.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include "importer/file/json_pointer.h"
#include "importer/import_gltf.h"

namespace sinew {
namespace {

using gltf::Json;

constexpr std::string_view kRead[] = {
    "EXT_meshopt_compression",    "KHR_draco_mesh_compression",  "KHR_meshopt_compression",
    "EXT_texture_webp",           "KHR_animation_pointer",       "KHR_lights_punctual",
    "KHR_mesh_quantization",      "KHR_texture_transform",       "KHR_materials_emissive_strength",
    "KHR_materials_unlit",        "KHR_node_visibility",         "KHR_materials_pbrSpecularGlossiness",
    "EXT_mesh_gpu_instancing",    "KHR_materials_variants",
};

/// These only refine how a surface reflects light, or say who made the file.
constexpr std::string_view kReadPast[] = {
    "KHR_materials_anisotropy",   "KHR_materials_clearcoat",     "KHR_materials_dispersion",
    "KHR_materials_ior",          "KHR_materials_iridescence",   "KHR_materials_sheen",
    "KHR_materials_specular",     "KHR_materials_transmission",  "KHR_materials_volume",
    "KHR_materials_diffuse_transmission", "KHR_xmp_json_ld",
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

void check_minor_version(const Json& asset, IssueLog& log) {
  const std::string text = asset["version"].get<std::string>();
  if (const auto required = asset.find("minVersion"); required != asset.end()) {
    const auto minimum = parse_version(required->get<std::string>());
    if (!minimum || minimum->major != 2 || minimum->minor > 0)
      return log.report(Rule::asset_version, "/asset/minVersion", required->dump().substr(0, 40) + " is above 2.0");
  }
  if (parse_version(text)->minor > 0)
    log.report(Rule::asset_minor_version, "/asset/version", in_quotes(text) + " is read as 2.0");
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

}  // namespace

ExtensionSupport extension_support(std::string_view name) noexcept {
  if (std::find(std::begin(kRead), std::end(kRead), name) != std::end(kRead)) return ExtensionSupport::read;
  if (std::find(std::begin(kReadPast), std::end(kReadPast), name) != std::end(kReadPast)) return ExtensionSupport::read_past;
  return ExtensionSupport::unknown;
}

bool check_major_version(const Json& json, IssueLog& log) {
  static const Json::json_pointer at("/asset/version");
  if (!json.contains(at)) return true;
  const Json& said = json[at];
  if (!said.is_string() && !said.is_number()) return true;
  const std::string text = said.is_string() ? said.get<std::string>() : said.dump();
  const auto version = parse_version(text);
  const bool second = said.is_string() ? version && version->major == 2 : std::floor(said.get<double>()) == 2.0;
  if (!second) log.report(Rule::asset_version, at.to_string(), in_quotes(text) + " is not 2.x");
  return second;
}

void check_capabilities(const Json& json, std::uint32_t max_nodes, IssueLog& log) {
  check_minor_version(json["asset"], log);
  if (const auto required = json.find("extensionsRequired"); required != json.end())
    for (std::size_t i = 0; i < required->size(); ++i) {
      const auto name = (*required)[i].get<std::string>();
      if (extension_support(name) == ExtensionSupport::unknown)
        log.report(Rule::extension_required, pointer("extensionsRequired", i), in_quotes(name) + " is not supported");
    }
  check_list_sizes(json, max_nodes, log);
}

}  // namespace sinew
