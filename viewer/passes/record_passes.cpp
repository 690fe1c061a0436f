// SPDX-License-Identifier: MIT
#include "viewer/passes/record_passes.h"

#include "viewer/passes/rendering.h"
#include "viewer/passes/shadow_view.h"

namespace sinew::viewer {

namespace {

/// Cull modes of a draw, one for each time that it is drawn: blended double-sided surfaces are drawn back faces first.
std::span<const VkCullModeFlagBits> culled_sides(const Draw& draw, Pass pass) noexcept {
  static constexpr std::array nothing = {VK_CULL_MODE_NONE}, back = {VK_CULL_MODE_BACK_BIT};
  static constexpr std::array back_faces_first = {VK_CULL_MODE_FRONT_BIT, VK_CULL_MODE_BACK_BIT};
  if (pass == Pass::shadow) return nothing;  // thin single-sided surfaces cast shadows from both sides
  if (!draw.surface.double_sided || draw.topology != Topology::triangles) return back;
  if (pass == Pass::transparent) return back_faces_first;
  return nothing;
}

std::span<const Through> steps_of(const FrameFeatures& frame, const Draw& draw, Pass pass) noexcept {
  static constexpr std::array at_once = {Through::nothing};
  static constexpr std::array plain = {Through::filter, Through::light};
  static constexpr std::array blurred = {Through::filter_drawn, Through::blurred_backdrop, Through::light};
  static constexpr std::array sharp = {Through::filter_drawn, Through::sharp_backdrop, Through::light};
  static constexpr std::array frosted = {Through::erase, Through::frosted};
  static constexpr std::array frosted_blurred = {Through::erase, Through::frosted_blurred};
  static constexpr std::array frosted_sharp = {Through::erase, Through::frosted_sharp};
  if (pass != Pass::transparent || !draw.transmits || frame.gooch) return at_once;
  const auto step = [&](std::span<const Through> clear, std::span<const Through> rough) {
    return draw.frosted ? rough : clear;
  };
  if (frame.transparent_background || frame.backdrop == Backdrop::plain) return step(plain, frosted);
  if (frame.backdrop == Backdrop::sharp) return step(sharp, frosted_sharp);
  return step(blurred, frosted_blurred);
}

void bind_draw(const PassContext& context, const Draw& draw) {
  const VkCommandBuffer commands = context.commands;
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, context.layout, 1, 1, &draw.material, 0, nullptr);
  vkCmdPushConstants(commands, context.layout, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                     sizeof(DrawConstants), &draw.constants);
  vkCmdBindVertexBuffers2(commands, 0, kAttributeCount, draw.buffers.data(), draw.offsets.data(), nullptr,
                          draw.strides.data());
  vkCmdBindIndexBuffer(commands, draw.indices, draw.indices_at, VK_INDEX_TYPE_UINT32);
  vkCmdSetFrontFace(commands, draw.mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
}

/// Draws meshes. Each draw adds its topology, alpha test, surface and step to `key`.
void draw_meshes(const PassContext& context, std::span<const Draw> draws, MeshPipelineKey key) {
  const VkCommandBuffer commands = context.commands;
  const VkDescriptorSet frame_set = key.pass == Pass::shadow        ? context.set.without_shadow()
                                    : key.pass == Pass::transparent ? context.set.with_behind()
                                                                    : context.set.set();
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, context.layout, 0, 1, &frame_set, 0, nullptr);
  key.frame = context.features;
  VkPipeline bound = VK_NULL_HANDLE;
  for (const Draw& draw : draws) {
    key.topology = draw.topology;
    key.surface = draw.surface;
    key.covers = key.pass == Pass::transparent && !draw.blended;
    key.masked = draw.masked && !key.after_prepass;  // after the prepass, the EQUAL depth test is the alpha test
    bind_draw(context, draw);
    for (const VkCullModeFlagBits culled : culled_sides(draw, key.pass)) {
      vkCmdSetCullMode(commands, culled);
      for (const Through step : steps_of(context.features, draw, key.pass)) {
        key.through = step;
        const VkPipeline pipeline = context.pipelines.mesh(key);
        if (pipeline != bound) vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
        bound = pipeline;
        vkCmdDrawIndexed(commands, draw.index_count, 1, 0, 0, 0);
      }
    }
  }
}

/// in   pass  Pass::ground, or Pass::normal_depth for the ground's prepass
void draw_ground(const PassContext& context, Pass pass) {
  const VkDescriptorSet set = context.set.set();
  const bool grid = pass == Pass::ground && context.inputs.options.ground.look == GroundLook::grid;
  vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, context.layout, 0, 1, &set, 0, nullptr);
  vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS,
                    context.pipelines.screen({.pass = pass, .grid = grid, .frame = context.features}));
  vkCmdDraw(context.commands, 6, 1, 0, 0);
}

/// Covers the target with one triangle.
void draw_screen(const PassContext& context, VkPipeline pipeline, VkDescriptorSet set) {
  vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, context.layout, 0, 1, &set, 0, nullptr);
  vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
  vkCmdDraw(context.commands, 3, 1, 0, 0);
}

void record_shadow(const PassContext& context) {
  context.targets.next_use(context.commands, Target::shadow, kWriteDepth, false);
  {
    const ShadowTiles tiles(context.graph.shadow_maps);
    const Rendering rendering(context.commands, {.depth = context.targets.view(Target::shadow),
                                                 .depth_write = true,
                                                 .extent = {kShadowSize * tiles.columns, kShadowSize * tiles.rows}});
    for (std::uint32_t map = 0; map < context.graph.shadow_maps; ++map) {
      const std::uint32_t x = kShadowSize * (map % tiles.columns), y = kShadowSize * (map / tiles.columns);
      set_area(context.commands,
               {{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)}, {kShadowSize, kShadowSize}});
      draw_meshes(context, context.draws.casters(), {.pass = Pass::shadow, .shadow_map = map, .depth_only = true});
    }
  }
  context.targets.next_use(context.commands, Target::shadow, kReadDepth);
}

void record_normal_depth(const PassContext& context) {
  context.targets.next_use(context.commands, Target::depth, kWriteDepth, false);
  const bool normals = context.graph.normal_image;
  if (normals) context.targets.next_use(context.commands, Target::normals, kWriteColor, false);
  {
    const VkImageView color = normals ? context.targets.view(Target::normals) : VK_NULL_HANDLE;
    const Rendering rendering(context.commands, {.color = color,
                                                 .load = VK_ATTACHMENT_LOAD_OP_CLEAR,
                                                 .depth = context.targets.view(Target::depth),
                                                 .depth_write = true,
                                                 .extent = context.targets.extent()});
    draw_meshes(context, context.draws.opaque(), {.pass = Pass::normal_depth, .depth_only = !normals});
    if (context.graph.ground_occluded) draw_ground(context, Pass::normal_depth);
  }
  context.targets.next_use(context.commands, Target::depth, kReadDepth);
  if (normals) context.targets.next_use(context.commands, Target::normals, kReadInShader);
}

/// Draws into an ambient occlusion image, only where surfaces may be. Elsewhere it is cleared to 0, the distance that
/// readers treat as "no surface".
void draw_occlusion(const PassContext& context, Target to, VkPipeline pipeline, VkDescriptorSet set) {
  context.targets.next_use(context.commands, to, kWriteColor, false);
  {
    const Rendering rendering(context.commands, {.color = context.targets.view(to),
                                                 .load = VK_ATTACHMENT_LOAD_OP_CLEAR,
                                                 .extent = context.targets.ao_extent()});
    vkCmdSetScissor(context.commands, 0, 1, &context.occluded);
    draw_screen(context, pipeline, set);
  }
  context.targets.next_use(context.commands, to, kReadInShader);
}

void record_ssao(const PassContext& context) {
  const OcclusionMethod method = context.inputs.options.ao.method;
  draw_occlusion(context, Target::ao,
                 context.pipelines.screen({.pass = Pass::ssao, .occlusion = method, .frame = context.features}),
                 context.set.set());
}

void record_ssao_blur(const PassContext& context, bool vertical) {
  const Pass pass = vertical ? Pass::blur_vertical : Pass::blur_horizontal;
  draw_occlusion(context, vertical ? Target::ao : Target::half_blurred_ao,
                 context.pipelines.screen({.pass = pass, .frame = context.features}),
                 vertical ? context.set.between_blurs() : context.set.set());
}

/// The images that the scene is shaded into. With multisampling, the last pass over the scene resolves them.
struct SceneTargets {
  Target color, unlit, depth;
  bool sampled;

  explicit SceneTargets(const FrameGraph& graph)
      : color(graph.sampled ? Target::color_samples : Target::color),
        unlit(graph.sampled ? Target::unlit_samples : Target::unlit),
        depth(graph.sampled ? Target::depth_samples : Target::depth),
        sampled(graph.sampled) {}
};

/// Attaches a colour image of the scene, and its resolve image.
void attach(const PassContext& context, Target drawn, Target resolved, bool resolves, bool keep, VkImageView& view,
            VkImageView& resolve) {
  context.targets.next_use(context.commands, drawn, kWriteColor, keep);
  view = context.targets.view(drawn);
  if (!resolves) return;
  context.targets.next_use(context.commands, resolved, kWriteColor, false);
  resolve = context.targets.view(resolved);
}

/// Attaches the colour images of the scene to a pass; the last pass over them also resolves their samples.
/// in   keep  false = the contents are discarded
void attach_colors(const PassContext& context, Pass pass, bool keep, Attachments& attachments) {
  const SceneTargets scene(context.graph);
  const Pass last_opaque = context.graph.has(Pass::ground)    ? Pass::ground
                           : context.graph.has(Pass::outline) ? Pass::outline
                                                              : Pass::opaque;
  const Pass last = context.graph.has(Pass::transparent) ? Pass::transparent : last_opaque;
  const bool resolves = scene.sampled && (pass == last || (pass == last_opaque && context.graph.has(Pass::behind)));
  attachments.load = keep ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_CLEAR;
  attach(context, scene.color, Target::color, resolves, keep, attachments.color, attachments.resolve);
  if (context.graph.unlit_image)
    attach(context, scene.unlit, Target::unlit, resolves, keep, attachments.second, attachments.second_resolve);
}

/// Fills the multisampled depth image, because the prepass has one sample per pixel.
void record_depth_samples(const PassContext& context) {
  context.targets.next_use(context.commands, Target::depth_samples, kWriteDepth, false);
  {
    const Rendering rendering(context.commands, {.depth = context.targets.view(Target::depth_samples),
                                                 .depth_write = true,
                                                 .extent = context.targets.extent()});
    draw_meshes(context, context.draws.opaque(), {.pass = Pass::opaque, .depth_only = true});
  }
  context.targets.next_use(context.commands, Target::depth_samples, kReadDepth);
}

void record_opaque(const PassContext& context) {
  const SceneTargets scene(context.graph);
  if (scene.sampled) record_depth_samples(context);
  const bool depth_is_there = scene.sampled || context.graph.has(Pass::normal_depth);
  if (!depth_is_there) context.targets.next_use(context.commands, scene.depth, kWriteDepth, false);
  Attachments attachments{
      .depth = context.targets.view(scene.depth), .depth_write = !depth_is_there, .extent = context.targets.extent()};
  attach_colors(context, Pass::opaque, false, attachments);
  {
    const Rendering rendering(context.commands, attachments);
    draw_meshes(context, context.draws.opaque(), {.pass = Pass::opaque, .after_prepass = depth_is_there});
  }
  if (!depth_is_there) context.targets.next_use(context.commands, scene.depth, kReadDepth);
}

/// Attachments of a pass that blends over the opaque picture.
Attachments over_opaque(const PassContext& context, Pass pass) {
  Attachments attachments{.depth = context.targets.view(SceneTargets(context.graph).depth),
                          .extent = context.targets.extent()};
  attach_colors(context, pass, true, attachments);
  return attachments;
}

void record_outline(const PassContext& context) {
  const Rendering rendering(context.commands, over_opaque(context, Pass::outline));
  draw_screen(context, context.pipelines.screen({.pass = Pass::outline, .frame = context.features}), context.set.set());
}

void record_ground(const PassContext& context) {
  const Rendering rendering(context.commands, over_opaque(context, Pass::ground));
  draw_ground(context, Pass::ground);
}

void record_behind(const PassContext& context) {
  context.targets.copy_into_levels(context.commands, Target::color, Target::behind);
  context.targets.next_use(context.commands, Target::behind, kReadInShader);
  if (!context.graph.unlit_image) return;
  context.targets.copy_into_levels(context.commands, Target::unlit, Target::behind_unlit);
  context.targets.next_use(context.commands, Target::behind_unlit, kReadInShader);
}

void record_transparent(const PassContext& context) {
  const Rendering rendering(context.commands, over_opaque(context, Pass::transparent));
  draw_meshes(context, context.draws.blended(), {.pass = Pass::transparent});
}

/// Accumulates weighted sums, starting from 0. Draws are unsorted; depth is tested but not written, so blended surfaces
/// do not hide each other.
void record_weighted(const PassContext& context) {
  const bool sampled = context.graph.sampled;
  const auto drawn = [&](Target samples, Target alone) { return sampled ? samples : alone; };
  Attachments to{.load = VK_ATTACHMENT_LOAD_OP_CLEAR,
                 .depth = context.targets.view(SceneTargets(context.graph).depth),
                 .extent = context.targets.extent()};
  attach(context, drawn(Target::weighted_sums_samples, Target::weighted_sums), Target::weighted_sums, sampled, false,
         to.color, to.resolve);
  attach(context, drawn(Target::weighted_coverage_samples, Target::weighted_coverage), Target::weighted_coverage,
         sampled, false, to.second, to.second_resolve);
  if (context.graph.unlit_image)
    attach(context, drawn(Target::weighted_unlit_samples, Target::weighted_unlit), Target::weighted_unlit, sampled,
           false, to.third, to.third_resolve);
  {
    const Rendering rendering(context.commands, to);
    draw_meshes(context, context.draws.weighted(), {.pass = Pass::weighted});
  }
  for (const Target target : {Target::weighted_sums, Target::weighted_coverage})
    context.targets.next_use(context.commands, target, kReadInShader);
  if (context.graph.unlit_image) context.targets.next_use(context.commands, Target::weighted_unlit, kReadInShader);
}

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

void record_exposure(const PassContext& context) {
  end_scene(context);
  draw_exposure(context, Target::light_sums, {kExposureBlocks, kExposureBlocks}, context.set.set());
  draw_exposure(context, Target::exposure, {1, 1}, context.set.before_exposure());
}

void record_tonemap(const PassContext& context) {
  if (!context.graph.has(Pass::exposure)) end_scene(context);
  const Rendering rendering(context.commands, {.color = context.target.view, .extent = context.target.extent});
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

}  // namespace

void record_pass(Pass pass, const PassContext& context) {
  switch (pass) {
    case Pass::shadow: return record_shadow(context);
    case Pass::normal_depth: return record_normal_depth(context);
    case Pass::ssao: return record_ssao(context);
    case Pass::blur_horizontal: return record_ssao_blur(context, false);
    case Pass::blur_vertical: return record_ssao_blur(context, true);
    case Pass::opaque: return record_opaque(context);
    case Pass::outline: return record_outline(context);
    case Pass::ground: return record_ground(context);
    case Pass::behind: return record_behind(context);
    case Pass::transparent: return record_transparent(context);
    case Pass::weighted: return record_weighted(context);
    case Pass::exposure: return record_exposure(context);
    case Pass::tonemap: return record_tonemap(context);
    case Pass::show: return record_show(context);
    case Pass::overlay: return record_overlay(context);
  }
}

}  // namespace sinew::viewer
