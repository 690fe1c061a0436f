// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "viewer/upload/upload_textures.h"

namespace sinew::viewer {

/// Mirrors shaders/material.glsl, std140.
struct TextureTransformUniforms {
  glm::vec4 row_u, row_v;
};

inline constexpr std::size_t kMaterialTextures = 5;  ///< base colour, metallic-roughness, normal, occlusion, emissive
inline constexpr std::size_t kLayerTextures = 12;  ///< textures of the material layers, in the order of texture_uses()

inline constexpr std::size_t kSpecularColor = 1;    ///< index of the specular colour texture among the layer textures
inline constexpr std::size_t kClearcoatNormal = 4;  ///< index of the clearcoat normal texture among the layer textures

/// Descriptor places for material textures: Vulkan guarantees 16 images per shader stage, and a frame uses 9. Layer
/// textures take the places that the five base textures leave free, and share the places of equal images.
inline constexpr std::size_t kTexturePlaces = 7;

struct MaterialUniforms {
  glm::vec4 base_color;
  glm::vec3 emissive;
  float alpha_cutoff;
  float metallic, roughness, normal_scale, occlusion_strength;
  glm::vec3 dielectric_f0;
  float specular;
  float clearcoat, clearcoat_roughness, clearcoat_normal_scale, transmission;
  glm::vec3 sheen_color;
  float sheen_roughness;
  float iridescence, film_ior, film_thinnest_m, film_thickest_m;
  glm::vec2 anisotropy_turn;  ///< cosine and sine of the rotation
  float anisotropy, thickness_m;
  glm::vec3 absorption_per_m;
  float inverse_ior;
  std::array<TextureTransformUniforms, kMaterialTextures + kLayerTextures> transforms;
};
static_assert(sizeof(MaterialUniforms) == 16 * (9 + 2 * (kMaterialTextures + kLayerTextures)));

/// Material layers that a shader variant is compiled for.
struct LayerFeatures {
  bool specular = false, clearcoat = false, sheen = false, transmission = false;
  bool iridescence = false, anisotropy = false, volume = false;
  bool glossiness = false;  ///< Specular::has_glossiness, and its texture has a place
  /// 0 = no texture, else 1 + 2 * place + (1 for TEXCOORD_1).
  std::array<std::uint8_t, kLayerTextures> textures{};

  auto operator<=>(const LayerFeatures&) const = default;
};

/// Material properties that select a shader variant. Unlike the uniforms, clips never change them.
struct MaterialFeatures {
  bool unlit = false;
  std::array<std::uint8_t, kMaterialTextures> texcoord_sets{};  ///< 0 = no texture, 1 = TEXCOORD_0, 2 = TEXCOORD_1

  LayerFeatures layers;

  bool rip_maps = false;  ///< shaders read rip maps instead of mip levels

  /// For rip maps: wrap mode of each place, 4 bits each; u in the lower two bits, v in the upper two.
  std::uint32_t wraps = 0;

  auto operator<=>(const MaterialFeatures&) const = default;
};

/// Content of one descriptor place for a texture.
struct TexturePlace {
  std::uint32_t texture = kNone;
  TexelUse use;
};

/// True if the surface shows what is behind it, by alpha blending or transmission. Such surfaces are drawn from far to
/// near.
bool shows_behind(const Material& material) noexcept;

MaterialFeatures material_features(const Material& material) noexcept;
std::array<TexturePlace, kTexturePlaces> texture_places(const Material& material) noexcept;
/// False if the material's layers have more images than there are places; the last ones are dropped.
bool shows_all_textures(const Material& material) noexcept;
MaterialUniforms material_uniforms(const Material& material) noexcept;

/// Descriptor set 1 of all geometry pipelines: the uniforms and kTexturePlaces textures. The caller destroys it.
VkDescriptorSetLayout make_material_layout(const Device& device);

/// One descriptor set for each material of the scene, plus a last one for primitives without a material (glTF's
/// default). If clips animate materials, each frame in flight has its own sets.
class MaterialSet {
 public:
  MaterialSet(Device& device, const Scene& scene, Staging& staging, std::uint32_t slot_count,
              const TextureFilter& filter = {});
  ~MaterialSet();
  MaterialSet(const MaterialSet&) = delete;
  MaterialSet& operator=(const MaterialSet&) = delete;

  VkDescriptorSet set_of(std::uint32_t material, std::uint32_t slot) const noexcept {
    return sets_[slot % slots_ * count_ + std::min(material, count_ - 1)];
  }

  const MaterialFeatures& features_of(std::uint32_t material) const noexcept {
    return features_[std::min(material, count_ - 1)];
  }

  std::uint64_t texel_bytes() const noexcept { return textures_.texel_bytes(); }

  /// Writes the uniforms of animated materials.
  /// in   slot  the GPU must have finished its last use;   materials[materials of the scene]
  void update(std::uint32_t slot, std::span<const Material> materials);

 private:
  Material usable(const Material& given) const;
  void allocate_sets();
  void write_uniforms(std::size_t set, const Material& material);
  void write_set(std::size_t set, const Material& given, Staging& staging);

  Device& device_;
  const Scene& scene_;
  TextureSet textures_;
  std::vector<std::uint32_t> animated_;
  std::uint32_t count_ = 0, slots_ = 1;
  Buffer uniforms_;
  VkDeviceSize stride_ = 0;
  VkDescriptorSetLayout layout_ = VK_NULL_HANDLE;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  std::vector<VkDescriptorSet> sets_;
  std::vector<MaterialFeatures> features_;  // [materials + 1]
};

}  // namespace sinew::viewer
