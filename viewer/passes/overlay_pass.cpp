// SPDX-License-Identifier: MIT
#include "viewer/passes/record_passes.h"

namespace sinew::viewer {

void record_overlay(const PassContext& context) {
  barrier(context.commands, context.target.image, VK_IMAGE_ASPECT_COLOR_BIT, kWriteColor, kWriteColor);
  const Rendering rendering(
      context.commands,
      {.color = context.target.view, .load = VK_ATTACHMENT_LOAD_OP_LOAD, .extent = context.target.extent});
  if (context.line_vertices > 0) {
    const VkDescriptorSet set = context.set.set();
    const VkDeviceSize offset = 0;
    vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, context.layout, 0, 1, &set, 0, nullptr);
    vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, context.pipelines.screen(Pass::overlay));
    vkCmdBindVertexBuffers(context.commands, 0, 1, &context.lines, &offset);
    vkCmdDraw(context.commands, context.line_vertices, 1, 0, 0);
  }
  if (context.inputs.overlay) context.inputs.overlay(context.commands);
}

}  // namespace sinew::viewer
