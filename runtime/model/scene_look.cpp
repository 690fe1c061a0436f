// SPDX-License-Identifier: MIT
#include "runtime/model/scene_look.h"

#include <algorithm>
#include <set>

#include "runtime/base/contract.h"

namespace sinew {
namespace {

template <int N>
std::span<float> numbers(glm::vec<N, float>& v) noexcept {
  return {&v.x, N};
}
std::span<float> numbers(float& x) noexcept { return {&x, 1}; }

std::span<float> components_of(Camera& camera, PropertyKind kind) noexcept {
  switch (kind) {
    case PropertyKind::camera_fov_y: return numbers(camera.fov_y_rad);
    case PropertyKind::camera_aspect: return numbers(camera.aspect);
    case PropertyKind::camera_half_width: return numbers(camera.half_width);
    case PropertyKind::camera_half_height: return numbers(camera.half_height);
    case PropertyKind::camera_near: return numbers(camera.near_m);
    case PropertyKind::camera_far: return numbers(camera.far_m);
    default: return {};
  }
}

std::span<float> components_of(Light& light, PropertyKind kind) noexcept {
  switch (kind) {
    case PropertyKind::light_color: return numbers(light.color);
    case PropertyKind::light_intensity: return numbers(light.intensity);
    case PropertyKind::light_range: return numbers(light.range_m);
    case PropertyKind::light_inner_cone: return numbers(light.inner_cone_rad);
    case PropertyKind::light_outer_cone: return numbers(light.outer_cone_rad);
    default: return {};
  }
}

std::span<float> components_of(Material& material, const PropertyTarget& target) noexcept {
  switch (target.kind) {
    case PropertyKind::base_color: return numbers(material.base_color);
    case PropertyKind::metallic: return numbers(material.metallic);
    case PropertyKind::roughness: return numbers(material.roughness);
    case PropertyKind::normal_scale: return numbers(material.normal_scale);
    case PropertyKind::occlusion_strength: return numbers(material.occlusion_strength);
    case PropertyKind::emissive: return numbers(material.emissive);
    case PropertyKind::emissive_strength: return numbers(material.emissive_strength);
    case PropertyKind::alpha_cutoff: return numbers(material.alpha_cutoff);
    case PropertyKind::texture_offset: return numbers(texture_of(material, target.slot).offset);
    case PropertyKind::texture_rotation: return numbers(texture_of(material, target.slot).rotation_rad);
    case PropertyKind::texture_scale: return numbers(texture_of(material, target.slot).scale);
    default: return {};
  }
}

}  // namespace

TextureUse& texture_of(Material& material, TextureSlot slot) noexcept { return texture_in_slot(material, slot); }

std::span<float> components_of(SceneLook& look, const PropertyTarget& target) noexcept {
  if (target.kind == PropertyKind::node_visible) return {};
  if (target.kind <= PropertyKind::camera_far) return components_of(look.cameras[target.index], target.kind);
  if (target.kind <= PropertyKind::light_outer_cone) return components_of(look.lights[target.index], target.kind);
  return components_of(look.materials[target.index], target);
}

void apply_properties(const Scene& scene, std::span<const float> values, SceneLook& look) noexcept {
  if (values.empty()) return;
  for (const PropertyTable::Entry& entry : scene.properties.entries) {
    const std::span<float> to = components_of(look, entry.target);
    std::copy_n(values.begin() + entry.first, to.size(), to.begin());
  }
}

PropertyTable make_property_table(const Scene& scene) {
  std::set<PropertyTarget> moved;
  for (const Animation& animation : scene.animations)
    for (const PropertyTrack& track : animation.properties) moved.insert(track.target);
  PropertyTable table;
  if (moved.empty()) return table;
  SceneLook rest(scene);
  for (const PropertyTarget& target : moved) {
    const std::uint32_t count = component_count(target.kind);
    table.entries.push_back({target, static_cast<std::uint32_t>(table.rest.size()), count});
    if (target.kind == PropertyKind::node_visible) {
      const auto& hidden = scene.hidden_joints;
      table.rest.push_back(std::find(hidden.begin(), hidden.end(), target.index) == hidden.end() ? 1.0f : 0.0f);
      continue;
    }
    const std::span<float> components = components_of(rest, target);
    CONTRACT(components.size() == count);
    table.rest.insert(table.rest.end(), components.begin(), components.end());
  }
  return table;
}

}  // namespace sinew
