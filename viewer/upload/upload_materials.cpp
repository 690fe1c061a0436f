// SPDX-License-Identifier: MIT
#include "viewer/upload/upload_materials.h"

#include <cmath>
#include <cstring>

namespace sinew::viewer {

namespace {

/// eq   KHR_texture_transform: uv' = offset + R * (scale * uv); counter-clockwise as seen in the image, whose v points
///      down
TextureTransformUniforms texture_transform(const TextureUse& use) noexcept {
  if (!use.used()) return {};
  const float c = std::cos(use.rotation_rad), s = std::sin(use.rotation_rad);
  return {{c * use.scale.x, s * use.scale.y, use.offset.x, 0.0f},
          {-s * use.scale.x, c * use.scale.y, use.offset.y, 0.0f}};
}

}  // namespace

MaterialUniforms material_uniforms(const Material& m) noexcept {
  return {m.base_color,
          m.emissive * m.emissive_strength,
          m.alpha_cutoff,
          m.metallic,
          m.roughness,
          m.normal_scale,
          m.occlusion_strength,
          {texture_transform(m.base_color_texture), texture_transform(m.metallic_roughness_texture),
           texture_transform(m.normal_texture), texture_transform(m.occlusion_texture),
           texture_transform(m.emissive_texture)}};
}

MaterialFeatures material_features(const Material& m) noexcept {
  const auto set_of = [](const TextureUse& use) -> std::uint8_t { return !use.used() ? 0 : use.texcoord == 1 ? 2 : 1; };
  return {m.unlit,
          {set_of(m.base_color_texture), set_of(m.metallic_roughness_texture), set_of(m.normal_texture),
           set_of(m.occlusion_texture), set_of(m.emissive_texture)}};
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

MaterialSet::MaterialSet(Device& device, const Scene& scene, Staging& staging, std::uint32_t slot_count)
    : device_(device),
      scene_(scene),
      textures_(device),
      count_(static_cast<std::uint32_t>(scene.materials.size() + 1)) {
  for (const PropertyTable::Entry& entry : scene.properties.entries)
    if (entry.target.kind >= PropertyKind::base_color) animated_.push_back(entry.target.index);
  std::sort(animated_.begin(), animated_.end());
  animated_.erase(std::unique(animated_.begin(), animated_.end()), animated_.end());
  if (!animated_.empty()) slots_ = slot_count;
  layout_ = make_material_layout(device);
  allocate_sets();
  const VkDeviceSize alignment = device.limits().minUniformBufferOffsetAlignment;
  stride_ = (sizeof(MaterialUniforms) + alignment - 1) / alignment * alignment;
  uniforms_ = Buffer(device, stride_ * sets_.size(), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, MemoryUse::upload);
  for (std::size_t set = 0; set < sets_.size(); ++set) {
    const std::size_t material = set % count_;
    write_set(set, material < scene.materials.size() ? scene.materials[material] : Material{}, staging);
  }
  for (std::size_t material = 0; material < count_; ++material)
    features_.push_back(
        material_features(material < scene.materials.size() ? usable(scene.materials[material]) : Material{}));
}

void MaterialSet::allocate_sets() {
  const std::uint32_t count = count_ * slots_;
  const std::array<VkDescriptorPoolSize, 2> sizes = {
      {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, count}, {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 5 * count}}};
  VkDescriptorPoolCreateInfo pool{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  pool.maxSets = count;
  pool.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
  pool.pPoolSizes = sizes.data();
  must(vkCreateDescriptorPool(device_.handle(), &pool, nullptr, &pool_), "vkCreateDescriptorPool");

  const std::vector<VkDescriptorSetLayout> layouts(count, layout_);
  sets_.resize(count);
  VkDescriptorSetAllocateInfo allocate{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  allocate.descriptorPool = pool_;
  allocate.descriptorSetCount = count;
  allocate.pSetLayouts = layouts.data();
  must(vkAllocateDescriptorSets(device_.handle(), &allocate, sets_.data()), "vkAllocateDescriptorSets");
}

MaterialSet::~MaterialSet() {
  vkDestroyDescriptorPool(device_.handle(), pool_, nullptr);
  vkDestroyDescriptorSetLayout(device_.handle(), layout_, nullptr);
}

void MaterialSet::update(std::uint32_t slot, std::span<const Material> materials) {
  for (const std::uint32_t m : animated_) write_uniforms(slot % slots_ * count_ + m, usable(materials[m]));
}

/// The material without its unreadable data textures; only their factors count then.
Material MaterialSet::usable(const Material& given) const {
  Material material = given;
  for (TextureUse* data : {&material.metallic_roughness_texture, &material.normal_texture, &material.occlusion_texture})
    if (!readable(scene_, *data)) *data = {};
  return material;
}

void MaterialSet::write_uniforms(std::size_t set, const Material& material) {
  const MaterialUniforms uniforms = material_uniforms(material);
  std::memcpy(uniforms_.mapped() + stride_ * set, &uniforms, sizeof(uniforms));
}

void MaterialSet::write_set(std::size_t set, const Material& given, Staging& staging) {
  const Material material = usable(given);
  const Scene& scene = scene_;
  write_uniforms(set, material);
  const VkDescriptorBufferInfo buffer{uniforms_.handle(), stride_ * set, sizeof(MaterialUniforms)};
  const std::array<VkDescriptorImageInfo, 5> images = {
      textures_.use(scene, material.base_color_texture.texture, true, staging),
      textures_.use(scene, material.metallic_roughness_texture.texture, false, staging),
      textures_.use(scene, material.normal_texture.texture, false, staging),
      textures_.use(scene, material.occlusion_texture.texture, false, staging),
      textures_.use(scene, material.emissive_texture.texture, true, staging)};
  std::array<VkWriteDescriptorSet, 6> writes{};
  for (std::uint32_t i = 0; i < writes.size(); ++i) {
    writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    writes[i].dstSet = sets_[set];
    writes[i].dstBinding = i;
    writes[i].descriptorCount = 1;
    writes[i].descriptorType = i == 0 ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    writes[i].pBufferInfo = i == 0 ? &buffer : nullptr;
    writes[i].pImageInfo = i == 0 ? nullptr : &images[i - 1];
  }
  vkUpdateDescriptorSets(device_.handle(), static_cast<std::uint32_t>(writes.size()), writes.data(), 0, nullptr);
}

}  // namespace sinew::viewer
