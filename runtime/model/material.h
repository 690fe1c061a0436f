// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/animation/skeleton.h"

namespace sinew {

enum class AlphaMode : std::uint8_t { opaque, mask, blend };
enum class Filter : std::uint8_t { nearest, linear };
enum class Wrap : std::uint8_t { repeat, clamp_to_edge, mirrored_repeat };

struct Sampler {
  Filter magnify = Filter::linear;
  Filter minify = Filter::linear;
  Filter mipmap = Filter::linear;
  bool use_mipmaps = true;
  Wrap wrap_u = Wrap::repeat;
  Wrap wrap_v = Wrap::repeat;
};

/// Decoded pixels, or an empty image with the reason why the file's image is missing or unreadable. The rest of the
/// file still loads, and a visible placeholder is drawn (G66).
struct Image {
  std::string name;
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  ///< [4 * width * height] rows from the top; empty where only the header was read
  std::string missing_reason;      ///< not empty = draw the placeholder
  std::string mime_type;           ///< by content, such as "image/png"; empty when missing
  std::uint64_t encoded_size = 0;  ///< bytes in the file
  std::vector<std::byte> encoded;  ///< these bytes, if the importer was asked to keep them
};

struct Texture {
  std::uint32_t image = kNone;
  Sampler sampler;
};

/// A use of a texture by a material. KHR_texture_transform: uv' = T(offset) * R(rotation) * S(scale) * uv (G60).
struct TextureUse {
  std::uint32_t texture = kNone;
  std::uint32_t texcoord = 0;
  glm::vec2 offset{0.0f};
  float rotation_rad = 0.0f;
  glm::vec2 scale{1.0f};

  bool used() const noexcept { return texture != kNone; }
};

/// glTF 2.0 metallic-roughness material; factors are linear, colour textures are sRGB.
struct Material {
  std::string name;
  glm::vec4 base_color{1.0f};
  TextureUse base_color_texture;
  float metallic = 1.0f;
  float roughness = 1.0f;
  TextureUse metallic_roughness_texture;  ///< G roughness, B metallic, linear
  TextureUse normal_texture;
  float normal_scale = 1.0f;
  TextureUse occlusion_texture;  ///< R, linear
  float occlusion_strength = 1.0f;
  glm::vec3 emissive{0.0f};        ///< 0 to 1, times the strength
  float emissive_strength = 1.0f;  ///< KHR_materials_emissive_strength
  TextureUse emissive_texture;
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false;
  bool unlit = false;  ///< KHR_materials_unlit
};

}  // namespace sinew
