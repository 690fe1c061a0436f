// SPDX-License-Identifier: MIT
#include "importer/read/property_pointer.h"

#include <charconv>
#include <utility>

#include "importer/read/json_member.h"
#include "runtime/animation/property_track.h"

namespace sinew {
namespace {

using gltf::Json;
using List = PointedProperty::List;

constexpr std::pair<std::string_view, List> kLists[] = {{"/nodes/", List::nodes},
                                                        {"/meshes/", List::meshes},
                                                        {"/cameras/", List::cameras},
                                                        {"/extensions/KHR_lights_punctual/lights/", List::lights},
                                                        {"/materials/", List::materials}};

struct Row {
  List list;
  std::string_view path;
  PropertyKind kind;
};
constexpr Row kRows[] = {
    {List::nodes, "extensions/KHR_node_visibility/visible", PropertyKind::node_visible},
    {List::cameras, "perspective/yfov", PropertyKind::camera_fov_y},
    {List::cameras, "perspective/aspectRatio", PropertyKind::camera_aspect},
    {List::cameras, "perspective/znear", PropertyKind::camera_near},
    {List::cameras, "perspective/zfar", PropertyKind::camera_far},
    {List::cameras, "orthographic/xmag", PropertyKind::camera_half_width},
    {List::cameras, "orthographic/ymag", PropertyKind::camera_half_height},
    {List::cameras, "orthographic/znear", PropertyKind::camera_near},
    {List::cameras, "orthographic/zfar", PropertyKind::camera_far},
    {List::lights, "color", PropertyKind::light_color},
    {List::lights, "intensity", PropertyKind::light_intensity},
    {List::lights, "range", PropertyKind::light_range},
    {List::lights, "spot/innerConeAngle", PropertyKind::light_inner_cone},
    {List::lights, "spot/outerConeAngle", PropertyKind::light_outer_cone},
    {List::materials, "pbrMetallicRoughness/baseColorFactor", PropertyKind::base_color},
    {List::materials, "pbrMetallicRoughness/metallicFactor", PropertyKind::metallic},
    {List::materials, "pbrMetallicRoughness/roughnessFactor", PropertyKind::roughness},
    {List::materials, "normalTexture/scale", PropertyKind::normal_scale},
    {List::materials, "occlusionTexture/strength", PropertyKind::occlusion_strength},
    {List::materials, "emissiveFactor", PropertyKind::emissive},
    {List::materials, "extensions/KHR_materials_emissive_strength/emissiveStrength", PropertyKind::emissive_strength},
    {List::materials, "alphaCutoff", PropertyKind::alpha_cutoff}};

constexpr std::pair<std::string_view, TextureSlot> kTextures[] = {
    {"pbrMetallicRoughness/baseColorTexture", TextureSlot::base_color},
    {"pbrMetallicRoughness/metallicRoughnessTexture", TextureSlot::metallic_roughness},
    {"normalTexture", TextureSlot::normal},
    {"occlusionTexture", TextureSlot::occlusion},
    {"emissiveTexture", TextureSlot::emissive}};
constexpr std::pair<std::string_view, PropertyKind> kTransforms[] = {
    {"/extensions/KHR_texture_transform/offset", PropertyKind::texture_offset},
    {"/extensions/KHR_texture_transform/rotation", PropertyKind::texture_rotation},
    {"/extensions/KHR_texture_transform/scale", PropertyKind::texture_scale}};

bool take(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

/// Parses an array index of RFC 6901: digits without a leading zero.
std::optional<std::uint32_t> take_index(std::string_view& text) {
  std::uint32_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  const auto length = static_cast<std::size_t>(end - text.data());
  if (error != std::errc() || (length > 1 && text.front() == '0')) return std::nullopt;
  text.remove_prefix(length);
  return index;
}

const Json* lights_of(const gltf::Document& document) {
  const Json* list = member(member(&document.extensions, "KHR_lights_punctual"), "lights");
  return list != nullptr && list->is_array() ? list : nullptr;
}

std::size_t size_of(const gltf::Document& document, List list) {
  switch (list) {
    case List::nodes: return document.nodes.size();
    case List::meshes: return document.meshes.size();
    case List::cameras: return document.cameras.size();
    case List::materials: return document.materials.size();
    case List::lights: break;
  }
  const Json* lights = lights_of(document);
  return lights == nullptr ? 0 : lights->size();
}

bool camera_defines(const tinygltf::Camera& camera, std::string_view path, PropertyKind kind) {
  if (!path.starts_with(camera.type)) return false;
  if (kind == PropertyKind::camera_aspect) return camera.perspective.aspectRatio != 0.0;
  return kind != PropertyKind::camera_far || gltf::depth_range(camera).far != 0.0;
}

bool light_defines(const gltf::Document& document, std::uint32_t index, PropertyKind kind) {
  const Json* light = &(*lights_of(document))[index];
  if (kind == PropertyKind::light_range) return member(light, "range") != nullptr;
  const bool cone = kind == PropertyKind::light_inner_cone || kind == PropertyKind::light_outer_cone;
  return !cone || member(light, "spot") != nullptr;
}

bool material_defines(const gltf::Material& material, const PropertyTarget& target) {
  switch (target.kind) {
    case PropertyKind::normal_scale: return material.normalTexture.index != gltf::kAbsent;
    case PropertyKind::occlusion_strength: return material.occlusionTexture.index != gltf::kAbsent;
    case PropertyKind::emissive_strength:
      return member(&material.extensions, "KHR_materials_emissive_strength") != nullptr;
    case PropertyKind::texture_offset:
    case PropertyKind::texture_rotation:
    case PropertyKind::texture_scale: {
      const gltf::TextureInfo info = texture_info(material, target.slot);
      return info.index != kNone && member(info.extensions, "KHR_texture_transform") != nullptr;
    }
    default: return true;
  }
}

/// True if the file has the object with the property, and the property itself unless glTF has a default for it.
bool is_defined(const gltf::Document& document, List list, std::string_view path, const PropertyTarget& target) {
  switch (list) {
    case List::nodes: return member(&document.nodes[target.index].extensions, "KHR_node_visibility") != nullptr;
    case List::cameras: return camera_defines(document.cameras[target.index], path, target.kind);
    case List::lights: return light_defines(document, target.index, target.kind);
    case List::materials: return material_defines(document.materials[target.index], target);
    case List::meshes: break;  // "weights" are not in the table
  }
  return true;
}

/// Parses "weights" and "weights/3" of a node or mesh, and whole properties of a node.
bool read_node_path(std::string_view path, PointedProperty& out) {
  if (path == "weights") {
    out.node_path = "weights";
    return true;
  }
  if (std::string_view rest = path; take(rest, "weights/")) {
    const auto element = take_index(rest);
    if (!element || !rest.empty()) return false;
    out.node_path = "weights";
    out.element = *element;
    return true;
  }
  if (out.list != List::nodes) return false;
  for (const std::string_view name : {"translation", "rotation", "scale"})
    if (path == name) out.node_path = name;
  return !out.node_path.empty();
}

std::optional<PropertyTarget> find_target(List list, std::string_view path) {
  for (const Row& row : kRows)
    if (row.list == list && row.path == path) return PropertyTarget{row.kind, 0, TextureSlot::base_color};
  if (list != List::materials) return std::nullopt;
  for (const auto& [texture, slot] : kTextures)
    if (std::string_view rest = path; take(rest, texture))
      for (const auto& [transform, kind] : kTransforms)
        if (rest == transform) return PropertyTarget{kind, 0, slot};
  return std::nullopt;
}

List list_of(PropertyKind kind) {
  if (kind == PropertyKind::node_visible) return List::nodes;
  if (kind <= PropertyKind::camera_far) return List::cameras;
  return kind <= PropertyKind::light_outer_cone ? List::lights : List::materials;
}

std::string path_of(const PropertyTarget& target, bool orthographic) {
  for (const auto& [transform, kind] : kTransforms)
    if (kind == target.kind)
      for (const auto& [texture, slot] : kTextures)
        if (slot == target.slot) return std::string(texture) + std::string(transform);
  for (const Row& row : kRows)
    if (row.kind == target.kind && (row.list != List::cameras || row.path.starts_with("orthographic") == orthographic))
      return std::string(row.path);
  return {};
}

}  // namespace

std::string property_pointer(const PropertyTarget& target, const Scene& scene) {
  const List list = list_of(target.kind);
  const std::uint32_t index = list == List::nodes ? scene.skeleton.node_of_joint[target.index] : target.index;
  const bool orthographic = list == List::cameras && !scene.cameras[target.index].perspective;
  std::string text;
  for (const auto& [prefix, named] : kLists)
    if (named == list) text = prefix;
  return text + std::to_string(index) + "/" + path_of(target, orthographic);
}

std::optional<PointedProperty> read_property_pointer(const gltf::Document& document, std::string_view text,
                                                     PointerFault& fault) {
  const auto fail = [&](const char* why) {
    fault.text = why;
    return std::nullopt;
  };
  PointedProperty out;
  std::string_view path;
  for (const auto& [prefix, list] : kLists)
    if (std::string_view rest = text; path.empty() && take(rest, prefix)) {
      path = rest;
      out.list = list;
    }
  const auto index = take_index(path);
  if (!index || !take(path, "/")) return fail("is not a pointer that the runtime animates");
  out.index = *index;
  const bool on_node = (out.list == List::nodes || out.list == List::meshes) && read_node_path(path, out);
  const auto target = on_node ? PropertyTarget{} : find_target(out.list, path);
  if (!target) return fail("is not a property that the runtime animates");
  if (*index >= size_of(document, out.list)) {
    fault.past_end = true;
    return fail("points past the end");
  }
  out.target = *target;
  out.target.index = out.index;
  if (!on_node && !is_defined(document, out.list, path, out.target))
    return fail("is not defined in the file and has no default");
  return out;
}

bool property_is_defined(const gltf::Document& document, const Scene& scene, const PropertyTarget& target) {
  PointerFault ignored_fault;
  return read_property_pointer(document, property_pointer(target, scene), ignored_fault).has_value();
}

}  // namespace sinew
