// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include <glm/vec4.hpp>

#include "viewer/upload/upload_textures.h"

namespace sinew::viewer {

/// Mirrors shaders/material.glsl, std140.
struct TextureUseUniforms {
  glm::vec4 row_u, row_v;
};

struct MaterialUniforms {
  glm::vec4 base_color, emissive, surface, kind;
  std::array<TextureUseUniforms, 5> uses;  ///< base colour, metallic-roughness, normal, occlusion, emissive
};
static_assert(sizeof(MaterialUniforms) == 16 * (4 + 2 * 5));

MaterialUniforms material_uniforms(const Material& material) noexcept;

/// Descriptor set 1 of all geometry pipelines: the uniforms and five textures. The caller destroys it.
VkDescriptorSetLayout make_material_layout(const Device& device);

/// One descriptor set per material of the scene, and a last one for primitives without material (glTF's default).
class MaterialSet {
 public:
  MaterialSet(Device& device, const Scene& scene, Staging& staging);
  ~MaterialSet();
  MaterialSet(const MaterialSet&) = delete;
  MaterialSet& operator=(const MaterialSet&) = delete;

  VkDescriptorSet set_of(std::uint32_t material) const noexcept {
    return sets_[material < sets_.size() - 1 ? material : sets_.size() - 1];
  }

 private:
  void write_set(const Scene& scene, const Material& given, std::size_t index, Staging& staging);

  Device& device_;
  TextureSet textures_;
  Buffer uniforms_;
  VkDeviceSize stride_ = 0;
  VkDescriptorSetLayout layout_ = VK_NULL_HANDLE;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  std::vector<VkDescriptorSet> sets_;
};

}  // namespace sinew::viewer
