// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "runtime/model/texture.h"

namespace sinew {

enum class AlphaMode : std::uint8_t { opaque, mask, blend };

/// Specular reflection of dielectric (non-metal) surfaces (KHR_materials_ior, KHR_materials_specular).
/// eq   f0 = min(((ior - 1) / (ior + 1))^2 * color, 1) * factor along the normal; `factor` at grazing angles
struct Specular {
  float ior = 1.5f;  ///< 0, or at least 1
  float factor = 1.0f;
  TextureUse texture;     ///< channel A, linear; multiplies the factor
  glm::vec3 color{1.0f};  ///< may exceed 1
  TextureUse color_texture;
  /// Channel A of color_texture multiplies 1 - roughness (KHR_materials_pbrSpecularGlossiness).
  bool has_glossiness = false;

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

/// A thin film over the surface whose reflections interfere (KHR_materials_iridescence); none if the factor is 0.
struct Iridescence {
  float factor = 0.0f;
  TextureUse texture;  ///< channel R, linear; multiplies the factor
  float ior = 1.3f;
  float thinnest_nm = 100.0f, thickest_nm = 400.0f;
  TextureUse thickness_texture;  ///< channel G, linear: from thinnest to thickest; unused = thickest
};

/// A highlight stretched along a direction of the surface (KHR_materials_anisotropy); none if the strength is 0.
struct Anisotropy {
  float strength = 0.0f;
  float rotation_rad = 0.0f;  ///< from the tangent towards the bitangent
  TextureUse texture;         ///< channels R and G: direction in tangent space, B: multiplies the strength; linear
};

/// The medium behind a surface that transmits (KHR_materials_volume); the surface is thin if the thickness is 0.
struct Volume {
  float thickness_m = 0.0f;             ///< in the space of the mesh
  TextureUse texture;                   ///< channel G, linear; multiplies the thickness
  float attenuation_distance_m = 0.0f;  ///< where attenuation_color is left of white light; 0 = light is not absorbed
  glm::vec3 attenuation_color{1.0f};
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
  Iridescence iridescence;
  Anisotropy anisotropy;
  Volume volume;

  /// True if shading reads tangents of the mesh.
  bool reads_tangents() const noexcept {
    return normal_texture.used() || clearcoat.normal_texture.used() || anisotropy.strength != 0.0f;
  }
};

/// Pointers to all texture uses of a material; pointers to const if the material is const.
template <class M>
auto texture_uses(M& m) noexcept {
  return std::array{&m.base_color_texture,
                    &m.metallic_roughness_texture,
                    &m.normal_texture,
                    &m.occlusion_texture,
                    &m.emissive_texture,
                    &m.specular.texture,
                    &m.specular.color_texture,
                    &m.clearcoat.texture,
                    &m.clearcoat.roughness_texture,
                    &m.clearcoat.normal_texture,
                    &m.sheen.color_texture,
                    &m.sheen.roughness_texture,
                    &m.transmission.texture,
                    &m.iridescence.texture,
                    &m.iridescence.thickness_texture,
                    &m.anisotropy.texture,
                    &m.volume.texture};
}

}  // namespace sinew
