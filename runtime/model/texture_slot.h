// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/animation/property_track.h"

namespace sinew {

/// The texture of a slot, in whatever form a material has its textures: by these member names.
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

}  // namespace sinew
