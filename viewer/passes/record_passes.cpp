// SPDX-License-Identifier: MIT
#include "viewer/passes/record_passes.h"

namespace sinew::viewer {

Rendering::Rendering(VkCommandBuffer commands, const Attachments& attachments) : commands_(commands) {
  VkRenderingAttachmentInfo color{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  color.imageView = attachments.color;
  color.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  color.loadOp = attachments.load;
  color.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  VkRenderingAttachmentInfo depth{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  depth.imageView = attachments.depth;
  depth.imageLayout = attachments.depth_write ? kWriteDepth.layout : kReadDepth.layout;
  depth.loadOp = attachments.depth_write ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
  depth.storeOp = attachments.depth_write ? VK_ATTACHMENT_STORE_OP_STORE : VK_ATTACHMENT_STORE_OP_NONE;
  VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
  info.renderArea.extent = attachments.extent;
  info.layerCount = 1;
  info.colorAttachmentCount = attachments.color ? 1 : 0;
  info.pColorAttachments = &color;
  info.pDepthAttachment = attachments.depth ? &depth : nullptr;
  vkCmdBeginRendering(commands, &info);
  const VkViewport viewport{
      0.0f, 0.0f, static_cast<float>(attachments.extent.width), static_cast<float>(attachments.extent.height),
      0.0f, 1.0f};
  const VkRect2D scissor{{0, 0}, attachments.extent};
  vkCmdSetViewport(commands, 0, 1, &viewport);
  vkCmdSetScissor(commands, 0, 1, &scissor);
}

namespace {

void draw_mesh(const PassContext& context, const Draw& draw, VkCullModeFlags cull) {
  vkCmdSetCullMode(context.commands, cull);
  vkCmdDrawIndexed(context.commands, draw.index_count, 1, 0, 0, 0);
}

}  // namespace

void draw_meshes(const PassContext& context, std::span<const Draw> draws, MeshPipelineKey key) {
  const VkCommandBuffer commands = context.commands;
  const VkDescriptorSet frame_set = context.set.set();
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, context.layout, 0, 1, &frame_set, 0, nullptr);
  VkPipeline bound = VK_NULL_HANDLE;
  for (const Draw& draw : draws) {
    key.topology = draw.topology;
    key.masked = draw.masked && !key.after_prepass;  // after the prepass, equal depth is the alpha test
    const VkPipeline pipeline = context.pipelines.mesh(key);
    if (pipeline != bound) vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline), bound = pipeline;
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, context.layout, 1, 1, &draw.material, 0,
                            nullptr);
    vkCmdPushConstants(commands, context.layout, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                       sizeof(DrawConstants), &draw.constants);
    vkCmdBindVertexBuffers2(commands, 0, kAttributeCount, draw.buffers.data(), draw.offsets.data(), nullptr,
                            draw.strides.data());
    vkCmdBindIndexBuffer(commands, draw.indices, draw.indices_at, VK_INDEX_TYPE_UINT32);
    vkCmdSetFrontFace(commands, draw.mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
    const bool sides = draw.double_sided && draw.topology == Topology::triangles;
    if (sides && key.pass == Pass::transparent) draw_mesh(context, draw, VK_CULL_MODE_FRONT_BIT);  // far side first
    draw_mesh(context, draw, sides && key.pass != Pass::transparent ? VK_CULL_MODE_NONE : VK_CULL_MODE_BACK_BIT);
  }
}

void draw_screen(const PassContext& context, VkPipeline pipeline, VkDescriptorSet set) {
  vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, context.layout, 0, 1, &set, 0, nullptr);
  vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
  vkCmdDraw(context.commands, 3, 1, 0, 0);
}

}  // namespace sinew::viewer
