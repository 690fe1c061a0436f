// SPDX-License-Identifier: MIT
#include "viewer/passes/rendering.h"

#include <array>

namespace sinew::viewer {
namespace {

VkRenderingAttachmentInfo color_attachment(VkImageView view, const Attachments& all, VkImageView resolve) {
  VkRenderingAttachmentInfo color{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  color.imageView = view;
  color.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  color.loadOp = all.load;
  color.clearValue.color = all.clear;
  color.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  if (resolve) {
    color.resolveMode = VK_RESOLVE_MODE_AVERAGE_BIT;
    color.resolveImageView = resolve;
    color.resolveImageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  }
  return color;
}

}  // namespace

void set_area(VkCommandBuffer commands, const VkRect2D& area) {
  const VkViewport viewport{static_cast<float>(area.offset.x),
                            static_cast<float>(area.offset.y),
                            static_cast<float>(area.extent.width),
                            static_cast<float>(area.extent.height),
                            0.0f,
                            1.0f};
  vkCmdSetViewport(commands, 0, 1, &viewport);
  vkCmdSetScissor(commands, 0, 1, &area);
}

Rendering::Rendering(VkCommandBuffer commands, const Attachments& attachments) : commands_(commands) {
  const std::array colors = {color_attachment(attachments.color, attachments, attachments.resolve),
                             color_attachment(attachments.second, attachments, attachments.second_resolve),
                             color_attachment(attachments.third, attachments, attachments.third_resolve)};
  VkRenderingAttachmentInfo depth{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  depth.imageView = attachments.depth;
  depth.imageLayout = attachments.depth_write ? kWriteDepth.layout : kReadDepth.layout;
  depth.loadOp = attachments.depth_write ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
  depth.storeOp = attachments.depth_write ? VK_ATTACHMENT_STORE_OP_STORE : VK_ATTACHMENT_STORE_OP_NONE;
  VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
  const bool part = attachments.within.extent.width > 0 && attachments.within.extent.height > 0;
  info.renderArea = part ? attachments.within : VkRect2D{{0, 0}, attachments.extent};
  info.layerCount = 1;
  info.colorAttachmentCount = !attachments.color ? 0 : attachments.third ? 3 : attachments.second ? 2 : 1;
  info.pColorAttachments = colors.data();
  info.pDepthAttachment = attachments.depth ? &depth : nullptr;
  vkCmdBeginRendering(commands, &info);
  set_area(commands, {{0, 0}, attachments.extent});
  if (part) vkCmdSetScissor(commands, 0, 1, &attachments.within);
}

}  // namespace sinew::viewer
