// SPDX-License-Identifier: MIT
#include "viewer/device/pipeline.h"

namespace sinew::viewer {

namespace {

struct Factors {
  VkBlendFactor color, stored_color, alpha, stored_alpha;
};

Factors factors_of(Blending blending) noexcept {
  constexpr auto zero = VK_BLEND_FACTOR_ZERO, one = VK_BLEND_FACTOR_ONE;
  constexpr auto rest = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA, uncovered = VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA;
  switch (blending) {
    case Blending::straight: return {VK_BLEND_FACTOR_SRC_ALPHA, rest, one, rest};
    case Blending::filter: return {zero, VK_BLEND_FACTOR_SRC_COLOR, one, rest};
    case Blending::uncovered: return {uncovered, one, uncovered, one};
    case Blending::erase: return {zero, rest, zero, rest};
    case Blending::add:
    case Blending::weighted: return {one, one, one, one};
    default: return {one, rest, one, rest};
  }
}

std::array<VkPipelineColorBlendAttachmentState, kMostColors> blend_states(const PipelineShape& shape) {
  VkPipelineColorBlendAttachmentState blend{};
  blend.colorWriteMask =
      VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
  blend.blendEnable = shape.blend;
  const Factors factors = factors_of(shape.blending);
  blend.srcColorBlendFactor = factors.color;
  blend.dstColorBlendFactor = factors.stored_color;
  blend.srcAlphaBlendFactor = factors.alpha;
  blend.dstAlphaBlendFactor = factors.stored_alpha;
  VkPipelineColorBlendAttachmentState second = blend;
  if (shape.blending == Blending::weighted) {
    second.dstColorBlendFactor = second.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
  } else if (!shape.adds_second) {
    second.srcAlphaBlendFactor = VK_BLEND_FACTOR_ZERO;
  }
  return {blend, second, blend};
}

std::vector<VkDynamicState> dynamic_states(const PipelineShape& shape) {
  std::vector<VkDynamicState> states = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  if (shape.meshes)
    states.insert(states.end(), {VK_DYNAMIC_STATE_CULL_MODE, VK_DYNAMIC_STATE_FRONT_FACE,
                                 VK_DYNAMIC_STATE_VERTEX_INPUT_BINDING_STRIDE});
  return states;
}

}  // namespace

VkPipeline make_pipeline(const Device& device, VkPipelineLayout layout, const PipelineShape& shape) {
  const ShaderModule vertex(device, shape.vertex), fragment(device, shape.fragment);
  std::array<VkSpecializationMapEntry, kShaderConstants> entries{};
  for (std::uint32_t id = 0; id < kShaderConstants; ++id) entries[id] = {id, 4 * id, 4};
  const VkSpecializationInfo constants{kShaderConstants, entries.data(), sizeof(shape.constants),
                                       shape.constants.data()};
  const std::array stages = {vertex.stage(VK_SHADER_STAGE_VERTEX_BIT, &constants),
                             fragment.stage(VK_SHADER_STAGE_FRAGMENT_BIT, &constants)};

  VkPipelineVertexInputStateCreateInfo input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  input.vertexBindingDescriptionCount = static_cast<std::uint32_t>(shape.bindings.size());
  input.pVertexBindingDescriptions = shape.bindings.data();
  input.vertexAttributeDescriptionCount = static_cast<std::uint32_t>(shape.attributes.size());
  input.pVertexAttributeDescriptions = shape.attributes.data();
  VkPipelineInputAssemblyStateCreateInfo assembly{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  assembly.topology = shape.topology;
  VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  viewport.viewportCount = viewport.scissorCount = 1;
  // Fields left at zero mean: filled polygons, no culling.
  VkPipelineRasterizationStateCreateInfo raster{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  raster.lineWidth = 1.0f;
  VkPipelineMultisampleStateCreateInfo samples{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  samples.rasterizationSamples = static_cast<VkSampleCountFlagBits>(shape.samples);
  VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  depth.depthTestEnable = shape.depth;
  depth.depthWriteEnable = shape.depth_write;
  depth.depthCompareOp = shape.depth_compare;
  const auto attachments = blend_states(shape);
  const bool draws_color = shape.color_format != VK_FORMAT_UNDEFINED;
  VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  blend.attachmentCount = draws_color ? shape.colors : 0;
  blend.pAttachments = attachments.data();
  const std::vector<VkDynamicState> states = dynamic_states(shape);
  VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
  dynamic.dynamicStateCount = static_cast<std::uint32_t>(states.size());
  dynamic.pDynamicStates = states.data();
  VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
  rendering.colorAttachmentCount = blend.attachmentCount;
  const std::array<VkFormat, kMostColors> formats = {shape.color_format, shape.color_format, shape.color_format};
  rendering.pColorAttachmentFormats = formats.data();
  rendering.depthAttachmentFormat = shape.depth ? VK_FORMAT_D32_SFLOAT : VK_FORMAT_UNDEFINED;

  VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO, &rendering};
  info.stageCount = static_cast<std::uint32_t>(stages.size());
  info.pStages = stages.data();
  info.pVertexInputState = &input;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &viewport;
  info.pRasterizationState = &raster;
  info.pMultisampleState = &samples;
  info.pDepthStencilState = &depth;
  info.pColorBlendState = &blend;
  info.pDynamicState = &dynamic;
  info.layout = layout;
  VkPipeline pipeline = VK_NULL_HANDLE;
  must(vkCreateGraphicsPipelines(device.handle(), device.pipeline_cache(), 1, &info, nullptr, &pipeline),
       "vkCreateGraphicsPipelines");
  return pipeline;
}

}  // namespace sinew::viewer
