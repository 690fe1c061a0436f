// SPDX-License-Identifier: MIT
#include "viewer/passes/pass_resources.h"

#include <cstring>

#include "viewer/passes/draw_list.h"
#include "viewer/upload/upload_materials.h"

namespace sinew::viewer {

namespace {

constexpr std::uint32_t kTargetBindings = 4;  // depth, normals, ambient visibility, colour
// 1 = the uniforms; 10 = environment, split sum, shadow map, unlit colours, exposure, 3 weighted sums, 2 of the picture
// behind.
constexpr std::uint32_t kFrameBindings = 1 + kTargetBindings + 10;

constexpr std::uint32_t kEnvironmentBinding = kTargetBindings + 1;  // also read at the corners of the backdrop

constexpr std::uint32_t kSets = 3;  // FrameSet::set() and its two variants

}  // namespace

PassLayouts::PassLayouts(const Device& device) : device_(device) {
  VkSamplerCreateInfo sampler{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  sampler.addressModeU = sampler.addressModeV = sampler.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  must(vkCreateSampler(device.handle(), &sampler, nullptr, &nearest_), "vkCreateSampler");
  sampler.magFilter = sampler.minFilter = VK_FILTER_LINEAR;
  sampler.maxLod = VK_LOD_CLAMP_NONE;
  must(vkCreateSampler(device.handle(), &sampler, nullptr, &linear_), "vkCreateSampler");
  std::array<VkDescriptorSetLayoutBinding, kFrameBindings> bindings{};
  for (std::uint32_t i = 0; i < kFrameBindings; ++i) {
    bindings[i] = {i, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr};
    if (i == 0) bindings[i].descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    if (i == 0 || i == kEnvironmentBinding) bindings[i].stageFlags |= VK_SHADER_STAGE_VERTEX_BIT;
  }
  VkDescriptorSetLayoutCreateInfo frame{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  frame.bindingCount = kFrameBindings;
  frame.pBindings = bindings.data();
  must(vkCreateDescriptorSetLayout(device.handle(), &frame, nullptr, &frame_), "vkCreateDescriptorSetLayout");
  material_ = make_material_layout(device);
  const std::array layouts = {frame_, material_};
  const VkPushConstantRange constants{VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                                      sizeof(DrawConstants)};
  VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  info.setLayoutCount = static_cast<std::uint32_t>(layouts.size());
  info.pSetLayouts = layouts.data();
  info.pushConstantRangeCount = 1;
  info.pPushConstantRanges = &constants;
  must(vkCreatePipelineLayout(device.handle(), &info, nullptr, &pipeline_), "vkCreatePipelineLayout");
}

PassLayouts::~PassLayouts() {
  vkDestroyPipelineLayout(device_.handle(), pipeline_, nullptr);
  vkDestroyDescriptorSetLayout(device_.handle(), material_, nullptr);
  vkDestroyDescriptorSetLayout(device_.handle(), frame_, nullptr);
  vkDestroySampler(device_.handle(), nearest_, nullptr);
  vkDestroySampler(device_.handle(), linear_, nullptr);
}

FrameSet::FrameSet(const Device& device, const PassLayouts& layouts)
    : device_(device),
      nearest_(layouts.nearest()),
      linear_(layouts.linear()),
      uniforms_(device, sizeof(FrameUniforms), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, MemoryUse::upload) {
  const std::array<VkDescriptorPoolSize, 2> sizes = {
      {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, kSets},
       {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, kSets * (kFrameBindings - 1)}}};
  VkDescriptorPoolCreateInfo pool{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  pool.maxSets = kSets;
  pool.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
  pool.pPoolSizes = sizes.data();
  must(vkCreateDescriptorPool(device.handle(), &pool, nullptr, &pool_), "vkCreateDescriptorPool");
  const std::array<VkDescriptorSetLayout, kSets> set_layouts = {layouts.frame(), layouts.frame(), layouts.frame()};
  VkDescriptorSetAllocateInfo allocate{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  allocate.descriptorPool = pool_;
  allocate.descriptorSetCount = kSets;
  allocate.pSetLayouts = set_layouts.data();
  must(vkAllocateDescriptorSets(device.handle(), &allocate, sets_.data()), "vkAllocateDescriptorSets");
}

FrameSet::~FrameSet() { vkDestroyDescriptorPool(device_.handle(), pool_, nullptr); }

void FrameSet::write(const FrameUniforms& uniforms, const FrameTargets& targets, const EnvironmentUpload& environment,
                     bool prepass) {
  std::memcpy(uniforms_.mapped(), &uniforms, sizeof(uniforms));
  const VkDescriptorBufferInfo buffer{uniforms_.handle(), 0, sizeof(FrameUniforms)};
  for (std::size_t s = 0; s < sets_.size(); ++s) {
    // Without a prepass no shader reads depth, and the set must not contain the depth attachment. The (missing) normal
    // image takes its place.
    const std::array<Target, kTargetBindings> bound = {prepass ? Target::depth : Target::normals, Target::normals,
                                                       s != 1 ? Target::ao : Target::half_blurred_ao, Target::color};
    const VkImageView shadow = s != 1 ? targets.view(Target::shadow) : targets.nothing();
    const auto behind = [&](Target target) { return s == 2 ? targets.view(target) : targets.nothing(); };
    const std::array<VkDescriptorImageInfo, 10> others = {
        environment.environment(),
        environment.split_sum(),
        {nearest_, shadow, VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL},
        {nearest_, targets.view(Target::unlit), VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL},
        {nearest_, targets.view(s != 1 ? Target::exposure : Target::light_sums), VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL},
        {nearest_, targets.view(Target::weighted_sums), VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL},
        {nearest_, targets.view(Target::weighted_coverage), VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL},
        {nearest_, targets.view(Target::weighted_unlit), VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL},
        {linear_, behind(Target::behind), VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL},
        {linear_, behind(Target::behind_unlit), VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL}};
    std::array<VkDescriptorImageInfo, kFrameBindings - 1> images{};
    std::array<VkWriteDescriptorSet, kFrameBindings> writes{};
    for (std::uint32_t i = 0; i < kFrameBindings; ++i) {
      writes[i].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
      writes[i].dstSet = sets_[s];
      writes[i].dstBinding = i;
      writes[i].descriptorCount = 1;
      writes[i].descriptorType = i == 0 ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
      if (i == 0) {
        writes[i].pBufferInfo = &buffer;
      } else {
        images[i - 1] = i > kTargetBindings ? others[i - 1 - kTargetBindings]
                                            : VkDescriptorImageInfo{nearest_, targets.view(bound[i - 1]),
                                                                    VK_IMAGE_LAYOUT_READ_ONLY_OPTIMAL};
        writes[i].pImageInfo = &images[i - 1];
      }
    }
    vkUpdateDescriptorSets(device_.handle(), kFrameBindings, writes.data(), 0, nullptr);
  }
}

}  // namespace sinew::viewer
