// SPDX-License-Identifier: MIT
#include "importer/file/check_capabilities.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include "importer/file/gltf_shape.h"
#include "importer/file/json_pointer.h"
#include "importer/import_gltf.h"

namespace sinew {
namespace {

constexpr std::string_view kRead[] = {
    "EXT_meshopt_compression",
    "KHR_draco_mesh_compression",
    "KHR_meshopt_compression",
    "EXT_texture_avif",
    "EXT_texture_webp",
    "KHR_animation_pointer",
    "KHR_lights_punctual",
    "KHR_mesh_quantization",
    "KHR_texture_basisu",
    "KHR_texture_transform",
    "KHR_materials_emissive_strength",
    "KHR_materials_anisotropy",
    "KHR_materials_clearcoat",
    "KHR_materials_iridescence",
    "KHR_materials_ior",
    "KHR_materials_sheen",
    "KHR_materials_specular",
    "KHR_materials_transmission",
    "KHR_materials_unlit",
    "KHR_materials_volume",
    "KHR_node_visibility",
    "KHR_materials_pbrSpecularGlossiness",
    "EXT_mesh_gpu_instancing",
    "KHR_materials_variants",
    "VRM",
    "VRMC_vrm",
    "VRMC_vrm_animation",
    "VRMC_node_constraint",
    "VRMC_springBone",
    "VRMC_springBone_extended_collider",
};

/// Ignored extensions. They refine reflection, offer alternative images, or hold metadata and application behaviour;
/// poses do not depend on them.
constexpr std::string_view kReadPast[] = {
    "KHR_materials_dispersion", "KHR_materials_diffuse_transmission",
    "MSFT_texture_dds",         "KHR_interactivity",
    "KHR_node_hoverability",    "KHR_node_selectability",
    "KHR_xmp_json_ld",          "KHR_xmp",
    "KHR_virtual_joints",
};

/// Prefixes of ignored extensions that describe characters in addition to nodes, meshes and clips.
constexpr std::string_view kReadPastFamilies[] = {"KHR_character", "KHR_avatar", "VRMC_"};

struct Version {
  int major = 0, minor = 0;
};

std::optional<Version> parse_version(std::string_view text) {
  Version version;
  const char *begin = text.data(), *end = begin + text.size();
  const auto major = std::from_chars(begin, end, version.major);
  if (major.ec != std::errc() || major.ptr == end || *major.ptr != '.') return std::nullopt;
  const auto minor = std::from_chars(major.ptr + 1, end, version.minor);
  if (minor.ec != std::errc() || minor.ptr != end) return std::nullopt;
  return version;
}

void check_minor_version(const JsonNode& asset, IssueLog& log) {
  const std::string_view text = text_of(*find_member(asset, "version"));
  if (const JsonNode* required = find_member(asset, "minVersion")) {
    const auto minimum = parse_version(text_of(*required));
    if (!minimum || minimum->major != 2 || minimum->minor > 0)
      return log.report(Rule::asset_version, "/asset/minVersion", in_quotes(text_of(*required)) + " is above 2.0");
  }
  if (parse_version(text)->minor > 0)
    log.report(Rule::asset_minor_version, "/asset/version", in_quotes(text) + " is read as 2.0");
}

void check_list_sizes(const JsonNode& json, std::uint32_t max_nodes, IssueLog& log) {
  constexpr std::size_t kMaxSmallList = 65536;
  constexpr std::string_view kLarge[] = {"accessors", "bufferViews", "meshes", "nodes"};
  for (const auto& [key, list] : json.GetObject()) {
    if (!list.IsArray()) continue;
    const std::string_view name = text_of(key);
    const bool large = std::find(std::begin(kLarge), std::end(kLarge), name) != std::end(kLarge);
    const std::size_t most = large ? max_nodes : std::min<std::size_t>(max_nodes, kMaxSmallList);
    if (list.Size() > most)
      log.report(Rule::too_many, pointer(name),
                 std::to_string(list.Size()) + " entries, at most " + std::to_string(most) + " are allowed");
  }
}

}  // namespace

ExtensionSupport extension_support(std::string_view name) noexcept {
  if (std::find(std::begin(kRead), std::end(kRead), name) != std::end(kRead)) return ExtensionSupport::read;
  if (std::find(std::begin(kReadPast), std::end(kReadPast), name) != std::end(kReadPast))
    return ExtensionSupport::read_past;
  for (const std::string_view family : kReadPastFamilies)
    if (name.starts_with(family)) return ExtensionSupport::read_past;
  return ExtensionSupport::unknown;
}

bool check_is_gltf(const JsonNode& json, IssueLog& log) {
  if (!json.IsObject() || json.MemberCount() == 0) return true;
  const auto known = gltf_shape().object->properties;
  const auto has = [&](const JsonProperty& property) { return find_member(json, property.name) != nullptr; };
  if (std::any_of(known.begin(), known.end(), has)) return true;
  log.report(Rule::not_gltf, "",
             "the file is JSON with nothing of glTF in it, neither \"asset\" nor \"nodes\"; its first member is " +
                 in_quotes(text_of(json.MemberBegin()->name)));
  return false;
}

bool check_major_version(const JsonNode& json, IssueLog& log) {
  const JsonNode* asset = json.IsObject() ? find_member(json, "asset") : nullptr;
  const JsonNode* said = asset != nullptr && asset->IsObject() ? find_member(*asset, "version") : nullptr;
  if (said == nullptr || !(said->IsString() || said->IsNumber())) return true;
  const std::string text = said->IsString() ? std::string(text_of(*said)) : to_json(*said).dump();
  const auto version = parse_version(text);
  const bool second = said->IsString() ? version && version->major == 2 : std::floor(said->GetDouble()) == 2.0;
  if (!second)
    log.report(Rule::asset_version, "/asset/version",
               in_quotes(text) + " is not 2.x" + (text.starts_with('1') ? "; convert the file to glTF 2.0" : ""));
  return second;
}

void check_capabilities(const JsonNode& json, std::uint32_t max_nodes, IssueLog& log) {
  check_minor_version(*find_member(json, "asset"), log);
  if (const JsonNode* required = find_member(json, "extensionsRequired"))
    for (rapidjson::SizeType i = 0; i < required->Size(); ++i) {
      const std::string_view name = text_of((*required)[i]);
      if (extension_support(name) == ExtensionSupport::unknown)
        log.report(Rule::extension_required, pointer("extensionsRequired", i), in_quotes(name) + " is not supported");
    }
  check_list_sizes(json, max_nodes, log);
}

}  // namespace sinew
