// SPDX-License-Identifier: MIT
#include "viewer/passes/record_display.h"

#include "viewer/passes/rendering.h"

namespace sinew::viewer {

namespace {

/// Draws one of the two small images of the automatic exposure.
void draw_exposure(const PassContext& context, Target target, VkExtent2D extent, VkDescriptorSet set) {
  context.targets.next_use(context.commands, target, kWriteColor, false);
  {
    const Rendering rendering(context.commands, {.color = context.targets.view(target), .extent = extent});
    const bool sums = target == Target::light_sums;
    draw_screen(context, context.pipelines.screen({.pass = Pass::exposure, .sums = sums, .frame = context.features}),
                set);
  }
  context.targets.next_use(context.commands, target, kReadInShader);
}

/// Makes the scene's colour images readable for the following passes.
void end_scene(const PassContext& context) {
  context.targets.next_use(context.commands, Target::color, kReadInShader);
  if (context.graph.unlit_image) context.targets.next_use(context.commands, Target::unlit, kReadInShader);
}

}  // namespace

void draw_screen(const PassContext& context, VkPipeline pipeline, VkDescriptorSet set) {
  vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, context.layout, 0, 1, &set, 0, nullptr);
  vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
  vkCmdDraw(context.commands, 3, 1, 0, 0);
}

void clear_target(const PassContext& context) {
  const RenderOptions& options = context.inputs.options;
  VkClearColorValue color{};
  for (int i = 0; i < 3 && !options.transparent_background; ++i)
    color.float32[i] = context.pipelines.encodes() ? options.background[i] : linear_from_srgb(options.background[i]);
  color.float32[3] = options.transparent_background ? 0.0f : 1.0f;
  const Rendering rendering(context.commands, {.color = context.target.view,
                                               .load = VK_ATTACHMENT_LOAD_OP_CLEAR,
                                               .clear = color,
                                               .extent = context.target.extent});
}

void record_exposure(const PassContext& context) {
  end_scene(context);
  draw_exposure(context, Target::light_sums, {kExposureBlocks, kExposureBlocks}, context.set.set());
  draw_exposure(context, Target::exposure, {1, 1}, context.set.before_exposure());
}

void record_backdrop(const PassContext& context) {
  const Rendering rendering(context.commands, {.color = context.target.view, .extent = context.target.extent});
  const bool at_corners = blurs_at_corners(context.features);
  const VkDescriptorSet set = context.set.set();
  vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, context.layout, 0, 1, &set, 0, nullptr);
  vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS,
                    context.pipelines.screen({.pass = Pass::backdrop, .frame = context.features}));
  vkCmdDraw(context.commands, at_corners ? 6 * kBackdropColumns * kBackdropRows : 6, 1, 0, 0);
}

void record_tonemap(const PassContext& context) {
  if (!context.graph.has(Pass::exposure)) end_scene(context);
  if (!context.graph.has(Pass::backdrop)) clear_target(context);
  barrier(context.commands, context.target.image, VK_IMAGE_ASPECT_COLOR_BIT, kWriteColor, kWriteColor);
  const Rendering rendering(context.commands, {.color = context.target.view,
                                               .load = VK_ATTACHMENT_LOAD_OP_LOAD,
                                               .extent = context.target.extent,
                                               .within = context.drawn});
  draw_screen(context, context.pipelines.screen({.pass = Pass::tonemap, .frame = context.features}), context.set.set());
}

void record_show(const PassContext& context) {
  const Rendering rendering(context.commands, {.color = context.target.view, .extent = context.target.extent});
  draw_screen(
      context,
      context.pipelines.screen({.pass = Pass::show, .show = context.inputs.options.show, .frame = context.features}),
      context.set.set());
}

void record_overlay(const PassContext& context) {
  barrier(context.commands, context.target.image, VK_IMAGE_ASPECT_COLOR_BIT, kWriteColor, kWriteColor);
  const Rendering rendering(
      context.commands,
      {.color = context.target.view, .load = VK_ATTACHMENT_LOAD_OP_LOAD, .extent = context.target.extent});
  if (context.line_vertices > 0) {
    const VkDescriptorSet set = context.set.set();
    const VkDeviceSize offset = 0;
    vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, context.layout, 0, 1, &set, 0, nullptr);
    vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS,
                      context.pipelines.screen({.pass = Pass::overlay, .frame = context.features}));
    vkCmdBindVertexBuffers(context.commands, 0, 1, &context.lines, &offset);
    vkCmdDraw(context.commands, 6, context.line_vertices / 2, 0, 0);
  }
  if (context.inputs.overlay) context.inputs.overlay(context.commands);
}

}  // namespace sinew::viewer
