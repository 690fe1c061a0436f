// SPDX-License-Identifier: MIT
#pragma once
#include <compare>
#include <cstdint>
#include <vector>

#include "runtime/animation/track.h"
#include "runtime/base/api.h"

namespace sinew {

/// The properties that a clip can animate besides joint transforms and morph weights.
enum class PropertyKind : std::uint8_t {
  node_visible,  ///< a flag: visible if >= 0.5. Hides a joint and all joints below it (KHR_node_visibility)
  camera_fov_y,
  camera_aspect,
  camera_half_width,
  camera_half_height,
  camera_near,
  camera_far,
  light_color,
  light_intensity,
  light_range,
  light_inner_cone,
  light_outer_cone,
  base_color,
  metallic,
  roughness,
  normal_scale,
  occlusion_strength,
  emissive,
  emissive_strength,
  alpha_cutoff,
  texture_offset,
  texture_rotation,
  texture_scale
};

/// The textures of a material, in the order of its members.
enum class TextureSlot : std::uint8_t { base_color, metallic_roughness, normal, occlusion, emissive };

/// The texture of a slot, in any material type with these members.
template <class AnyMaterial>
auto& texture_in_slot(AnyMaterial& material, TextureSlot slot) noexcept {
  switch (slot) {
    case TextureSlot::metallic_roughness: return material.metallic_roughness_texture;
    case TextureSlot::normal: return material.normal_texture;
    case TextureSlot::occlusion: return material.occlusion_texture;
    case TextureSlot::emissive: return material.emissive_texture;
    case TextureSlot::base_color: break;
  }
  return material.base_color_texture;
}

/// One animated property of a joint, camera, light or material.
struct PropertyTarget {
  PropertyKind kind = PropertyKind::node_visible;
  std::uint32_t index = 0;                     ///< joint, or index into the scene's cameras, lights or materials
  TextureSlot slot = TextureSlot::base_color;  ///< used by texture_offset, texture_rotation and texture_scale only

  friend auto operator<=>(const PropertyTarget&, const PropertyTarget&) = default;
};

SINEW_API std::uint32_t component_count(PropertyKind kind) noexcept;
inline bool is_flag(PropertyKind kind) noexcept { return kind == PropertyKind::node_visible; }

/// One animated property with its keys. Each component is interpolated by itself, even for angles and colours. Flags
/// use step interpolation only.
struct PropertyTrack {
  PropertyTarget target;
  WeightTrack values;  ///< target_count = component_count(target.kind)
};

/// The position of each animated property in the flat array of all property values of a scene.
struct SINEW_API PropertyTable {
  struct Entry {
    PropertyTarget target;
    std::uint32_t first = 0, count = 0;
  };
  std::vector<Entry> entries;  ///< sorted by target: each property that some clip animates, once
  std::vector<float> rest;     ///< [P] value of each component while no clip plays

  /// The entry of a property; null if no clip animates that property.      cost O(log entries)
  const Entry* find(const PropertyTarget& target) const noexcept;
};

}  // namespace sinew
