// SPDX-License-Identifier: MIT
#pragma once
#include <array>
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

/// Decoded pixels, or the reason why the image is missing or unreadable. A missing image does not fail the import; a
/// visible placeholder is drawn instead.
struct Image {
  std::string name;
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  ///< [4 * width * height] rows from the top; empty if only the header was read
  std::string missing_reason;      ///< not empty = the image is missing, so the placeholder is drawn
  std::string mime_type;           ///< from the content, such as "image/png"; empty if missing
  std::uint64_t encoded_size = 0;  ///< bytes in the file
  std::vector<std::byte> encoded;  ///< the bytes of the file, if the importer was asked to keep them
};

struct Texture {
  std::uint32_t image = kNone;
  Sampler sampler;
};

/// A texture as a material uses it.
/// eq   uv' = T(offset) * R(rotation) * S(scale) * uv   (KHR_texture_transform)
struct TextureUse {
  std::uint32_t texture = kNone;
  std::uint32_t texcoord = 0;
  glm::vec2 offset{0.0f};
  float rotation_rad = 0.0f;
  glm::vec2 scale{1.0f};

  bool used() const noexcept { return texture != kNone; }
};

/// Specular reflection of dielectric (non-metal) surfaces (KHR_materials_ior, KHR_materials_specular).
/// eq   f0 = min(((ior - 1) / (ior + 1))^2 * color, 1) * factor along the normal; `factor` at grazing angles
struct Specular {
  float ior = 1.5f;  ///< 0, or at least 1
  float factor = 1.0f;
  TextureUse texture;     ///< channel A, linear; multiplies the factor
  glm::vec3 color{1.0f};  ///< may exceed 1
  TextureUse color_texture;

  bool has_effect() const noexcept {
    return ior != 1.5f || factor != 1.0f || color != glm::vec3(1.0f) || texture.used() || color_texture.used();
  }
};

/// A clear coating over the surface (KHR_materials_clearcoat); none if the factor is 0.
struct Clearcoat {
  float factor = 0.0f;
  TextureUse texture;  ///< channel R, linear; multiplies the factor
  float roughness = 0.0f;
  TextureUse roughness_texture;  ///< channel G, linear
  TextureUse normal_texture;     ///< if unused, the coating has the normals of the mesh
  float normal_scale = 1.0f;
};

/// Reflection of fibres on the surface (KHR_materials_sheen); none if the colour is black.
struct Sheen {
  glm::vec3 color{0.0f};
  TextureUse color_texture;
  float roughness = 0.0f;
  TextureUse roughness_texture;  ///< channel A, linear
};

/// Transmission of light through a thin dielectric surface (KHR_materials_transmission).
struct Transmission {
  float factor = 0.0f;
  TextureUse texture;  ///< channel R, linear; multiplies the factor
};

/// glTF 2.0 metallic-roughness material; factors are linear, colour textures are sRGB.
struct Material {
  std::string name;
  glm::vec4 base_color{1.0f};
  TextureUse base_color_texture;
  float metallic = 1.0f;
  float roughness = 1.0f;
  TextureUse metallic_roughness_texture;  ///< channels G roughness, B metallic, linear
  TextureUse normal_texture;
  float normal_scale = 1.0f;
  TextureUse occlusion_texture;  ///< channel R, linear
  float occlusion_strength = 1.0f;
  glm::vec3 emissive{0.0f};        ///< 0 to 1; the strength multiplies it
  float emissive_strength = 1.0f;  ///< factor for `emissive` (KHR_materials_emissive_strength)
  TextureUse emissive_texture;
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false;
  bool unlit = false;  ///< no lighting: the base colour is shown (KHR_materials_unlit)
  Specular specular;
  Clearcoat clearcoat;
  Sheen sheen;
  Transmission transmission;
};

/// Pointers to all texture uses of a material; pointers to const if the material is const.
template <class M>
auto texture_uses(M& m) noexcept {
  return std::array{&m.base_color_texture,       &m.metallic_roughness_texture, &m.normal_texture,
                    &m.occlusion_texture,        &m.emissive_texture,           &m.specular.texture,
                    &m.specular.color_texture,   &m.clearcoat.texture,          &m.clearcoat.roughness_texture,
                    &m.clearcoat.normal_texture, &m.sheen.color_texture,        &m.sheen.roughness_texture,
                    &m.transmission.texture};
}

}  // namespace sinew
