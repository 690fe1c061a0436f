// SPDX-License-Identifier: MIT
#pragma once
#include <compare>
#include <cstdint>
#include <vector>

#include "runtime/animation/track.h"

namespace sinew {

/// What a clip can move beside the transforms of joints and morph weights.
enum class PropertyKind : std::uint8_t {
  node_visible,  ///< a flag: 1 from one half on. With a joint all below it disappear (KHR_node_visibility)
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

/// One property of one thing.
struct PropertyTarget {
  PropertyKind kind = PropertyKind::node_visible;
  std::uint32_t index = 0;                     ///< joint, or index into the scene's cameras, lights or materials
  TextureSlot slot = TextureSlot::base_color;  ///< of texture_offset, texture_rotation and texture_scale

  friend auto operator<=>(const PropertyTarget&, const PropertyTarget&) = default;
};

std::uint32_t component_count(PropertyKind kind) noexcept;
inline bool is_flag(PropertyKind kind) noexcept { return kind == PropertyKind::node_visible; }

/// A property over time: numbers that are interpolated one by one, whatever they mean. Flags have only steps.
struct PropertyTrack {
  PropertyTarget target;
  WeightTrack values;  ///< the property's components take the place of the morph targets
};

/// Where the animated properties of a scene lie in one flat array of numbers, one after another.
struct PropertyTable {
  struct Entry {
    PropertyTarget target;
    std::uint32_t first = 0, count = 0;
  };
  std::vector<Entry> entries;  ///< rising targets: everything that some clip moves, once
  std::vector<float> rest;     ///< [P] values while no clip plays

  /// Null when no clip moves it.      cost O(log entries)
  const Entry* find(const PropertyTarget& target) const noexcept;
};

}  // namespace sinew
