// SPDX-License-Identifier: MIT
#include "viewer/upload/upload_materials.h"

#include <cmath>
#include <cstring>

namespace sinew::viewer {

namespace {

/// KHR_texture_transform: uv' = offset + R * (scale * uv), counter-clockwise as seen in the image, whose v points down
/// (G60).
TextureUseUniforms texture_use(const TextureUse& use) noexcept {
  if (!use.used()) return {};
  const float c = std::cos(use.rotation_rad), s = std::sin(use.rotation_rad);
  const float texcoord = use.texcoord == 1 ? 2.0f : 1.0f;
  return {{c * use.scale.x, s * use.scale.y, use.offset.x, texcoord},
          {-s * use.scale.x, c * use.scale.y, use.offset.y, 0.0f}};
}

}  // namespace

MaterialUniforms material_uniforms(const Material& m) noexcept {
  return {m.base_color,
          glm::vec4(m.emissive * m.emissive_strength, m.alpha_cutoff),
          {m.metallic, m.roughness, m.normal_scale, m.occlusion_strength},
          {m.unlit ? 1.0f : 0.0f, 0.0f, 0.0f, 0.0f},
          {texture_use(m.base_color_texture), texture_use(m.metallic_roughness_texture), texture_use(m.normal_texture),
           texture_use(m.occlusion_texture), texture_use(m.emissive_texture)}};
}

VkDescriptorSetLayout make_material_layout(const Device& device) {
  std::array<VkDescriptorSetLayoutBinding, 6> bindings{};
  for (std::uint32_t i = 0; i < bindings.size(); ++i)
    bindings[i] = {i, i == 0 ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1,
                   VK_SHADER_STAGE_FRAGMENT_BIT, nullptr};
  VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  info.bindingCount = static_cast<std::uint32_t>(bindings.size());
  info.pBindings = bindings.data();
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  must(vkCreateDescriptorSetLayout(device.handle(), &info, nullptr, &layout), "vkCreateDescriptorSetLayout");
  return layout;
}

MaterialSet::MaterialSet(Device& device, const Scene& scene, Staging& staging) : device_(device), textures_(device) {
  const auto count = static_cast<std::uint32_t>(scene.materials.size() + 1);
  layout_ = make_material_layout(device);
  const std::array<VkDescriptorPoolSize, 2> sizes = {
      {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, count}, {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 5 * count}}};
  VkDescriptorPoolCreateInfo pool{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  pool.maxSets = count;
  pool.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
  pool.pPoolSizes = sizes.data();
  must(vkCreateDescriptorPool(device.handle(), &pool, nullptr, &pool_), "vkCreateDescriptorPool");

  const std::vector<VkDescriptorSetLayout> layouts(count, layout_);
  sets_.resize(count);
  VkDescriptorSetAllocateInfo allocate{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  allocate.descriptorPool = pool_;
  allocate.descriptorSetCount = count;
  allocate.pSetLayouts = layouts.data();
  must(vkAllocateDescriptorSets(device.handle(), &allocate, sets_.data()), "vkAllocateDescriptorSets");

  const VkDeviceSize alignment = device.limits().minUniformBufferOffsetAlignment;
  stride_ = (sizeof(MaterialUniforms) + alignment - 1) / alignment * alignment;
  uniforms_ = Buffer(device, stride_ * count, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, MemoryUse::upload);
  for (std::size_t i = 0; i < scene.materials.size(); ++i) write_set(scene, scene.materials[i], i, staging);
  write_set(scene, Material{}, scene.materials.size(), staging);
}

MaterialSet::~MaterialSet() {
  vkDestroyDescriptorPool(device_.handle(), pool_, nullptr);
  vkDestroyDescriptorSetLayout(device_.handle(), layout_, nullptr);
}

void MaterialSet::write_set(const Scene& scene, const Material& given, std::size_t index, Staging& staging) {
  Material material = given;
  for (TextureUse* data : {&material.metallic_roughness_texture, &material.normal_texture, &material.occlusion_texture})
    if (!readable(scene, *data)) *data = {};
  const MaterialUniforms uniforms = material_uniforms(material);
  std::memcpy(uniforms_.mapped() + stride_ * index, &uniforms, sizeof(uniforms));
  const VkDescriptorBufferInfo buffer{uniforms_.handle(), stride_ * index, sizeof(uniforms)};
  const std::array<VkDescriptorImageInfo, 5> images = {
      textures_.use(scene, material.base_color_texture.texture, true, staging),
      textures_.use(scene, material.metallic_roughness_texture.texture, false, staging),
      textures_.use(scene, material.normal_texture.texture, false, staging),
      textures_.use(scene, material.occlusion_texture.texture, false, staging),
      textures_.use(scene, material.emissive_texture.texture, true, staging)};
  std::array<VkWriteDescriptorSet, 6> writes{};
  for (std::uint32_t i = 0; i < writes.size(); ++i) {
    writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    writes[i].dstSet = sets_[index];
    writes[i].dstBinding = i;
    writes[i].descriptorCount = 1;
    writes[i].descriptorType = i == 0 ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    writes[i].pBufferInfo = i == 0 ? &buffer : nullptr;
    writes[i].pImageInfo = i == 0 ? nullptr : &images[i - 1];
  }
  vkUpdateDescriptorSets(device_.handle(), static_cast<std::uint32_t>(writes.size()), writes.data(), 0, nullptr);
}

}  // namespace sinew::viewer
