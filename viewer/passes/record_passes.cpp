// SPDX-License-Identifier: MIT
#include "viewer/passes/record_passes.h"

#include <array>

#include "viewer/passes/record_display.h"
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

/// Draws meshes of one pass. Each draw adds its topology, alpha test, surface and step to the pipeline's key.
class MeshDrawing {
 public:
  MeshDrawing(const PassContext& context, MeshPipelineKey key) : context_(context), key_(key) {
    const VkDescriptorSet frame_set = key.pass == Pass::shadow        ? context.set.without_shadow()
                                      : key.pass == Pass::transparent ? context.set.with_behind()
                                                                      : context.set.set();
    vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, context.layout, 0, 1, &frame_set, 0,
                            nullptr);
    key_.frame = context.features;
  }

  void draw(const Draw& draw) {
    key_.topology = draw.topology;
    key_.surface = draw.surface;
    key_.covers = key_.pass == Pass::transparent && !draw.blended;
    key_.masked = draw.masked && !key_.after_prepass;  // after the prepass, the EQUAL depth test is the alpha test
    bind_draw(context_, draw);
    for (const VkCullModeFlagBits culled : culled_sides(draw, key_.pass)) {
      vkCmdSetCullMode(context_.commands, culled);
      for (const Through step : steps_of(context_.features, draw, key_.pass)) {
        key_.through = step;
        const VkPipeline pipeline = context_.pipelines.mesh(key_);
        if (pipeline != bound_) vkCmdBindPipeline(context_.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
        bound_ = pipeline;
        vkCmdDrawIndexed(context_.commands, draw.index_count, 1, 0, 0, 0);
      }
    }
  }

 private:
  const PassContext& context_;
  MeshPipelineKey key_;
  VkPipeline bound_ = VK_NULL_HANDLE;
};

void draw_meshes(const PassContext& context, std::span<const Draw> draws, const MeshPipelineKey& key) {
  MeshDrawing drawing(context, key);
  for (const Draw& draw : draws) drawing.draw(draw);
}

/// Draws into a shadow map. Matrices do not depend on the camera, so that the map holds while only the camera moves.
void draw_casters(const PassContext& context, const ShadowView& map) {
  MeshDrawing drawing(context, {.pass = Pass::shadow, .depth_only = true});
  for (const Caster& caster : context.draws.casters()) {
    Draw draw = caster.draw;
    const std::array<glm::dvec4, 4> rows = map.map_from(caster.world_from_mesh);
    for (std::size_t i = 0; i < 3; ++i) draw.constants.view_from_mesh[i] = glm::vec4(rows[i]);
    draw.constants.shadow_w = glm::vec4(rows[3]);
    drawing.draw(draw);
  }
}

/// in   pass  Pass::ground, or Pass::normal_depth for the ground's prepass
void draw_ground(const PassContext& context, Pass pass) {
  const bool behind = pass == Pass::ground && context.graph.ground_behind;
  const VkDescriptorSet set = context.set.set();
  const bool grid = pass == Pass::ground && context.inputs.options.ground.look == GroundLook::grid;
  vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, context.layout, 0, 1, &set, 0, nullptr);
  vkCmdBindPipeline(
      context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS,
      context.pipelines.screen({.pass = pass, .grid = grid, .behind = behind, .frame = context.features}));
  vkCmdDraw(context.commands, 6, 1, 0, 0);
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
      draw_casters(context, context.shadow_views[map]);
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
    if (context.graph.ground_occluded) {
      vkCmdSetScissor(context.commands, 0, 1, &context.contact);
      draw_ground(context, Pass::normal_depth);
    }
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
/// in   around  true = the resolved image keeps what is outside the area of the meshes
void attach(const PassContext& context, Target drawn, Target resolved, bool resolves, bool keep, VkImageView& view,
            VkImageView& resolve, bool around = false) {
  context.targets.next_use(context.commands, drawn, kWriteColor, keep);
  view = context.targets.view(drawn);
  if (!resolves) return;
  context.targets.next_use(context.commands, resolved, kWriteColor, around);
  resolve = context.targets.view(resolved);
}

/// Attaches the colour images of the scene to a pass; the last pass over them also resolves their samples.
/// in   keep  false = the contents are discarded
void attach_colors(const PassContext& context, Pass pass, bool keep, Attachments& attachments) {
  const SceneTargets scene(context.graph);
  const bool ground = context.graph.has(Pass::ground) && !context.graph.ground_behind;
  const Pass last_opaque = ground ? Pass::ground : context.graph.has(Pass::outline) ? Pass::outline : Pass::opaque;
  const Pass last = context.graph.has(Pass::transparent) ? Pass::transparent : last_opaque;
  const bool resolves = scene.sampled && (pass == last || (pass == last_opaque && context.graph.has(Pass::behind)));
  attachments.load = keep ? VK_ATTACHMENT_LOAD_OP_LOAD : VK_ATTACHMENT_LOAD_OP_CLEAR;
  attach(context, scene.color, Target::color, resolves, keep, attachments.color, attachments.resolve,
         context.graph.ground_behind);
  if (context.graph.unlit_image)
    attach(context, scene.unlit, Target::unlit, resolves, keep, attachments.second, attachments.second_resolve);
}

/// Fills the multisampled depth image, because the prepass has one sample per pixel.
void record_depth_samples(const PassContext& context) {
  context.targets.next_use(context.commands, Target::depth_samples, kWriteDepth, false);
  {
    const Rendering rendering(context.commands, {.depth = context.targets.view(Target::depth_samples),
                                                 .depth_write = true,
                                                 .extent = context.targets.extent(),
                                                 .within = context.meshes});
    draw_meshes(context, context.draws.opaque(), {.pass = Pass::opaque, .depth_only = true});
  }
  context.targets.next_use(context.commands, Target::depth_samples, kReadDepth);
}

/// Clears the picture around the meshes, where the ground is drawn before anything else.
void clear_around_meshes(const PassContext& context) {
  context.targets.next_use(context.commands, Target::color, kWriteColor, false);
  const Rendering rendering(context.commands, {.color = context.targets.view(Target::color),
                                               .load = VK_ATTACHMENT_LOAD_OP_CLEAR,
                                               .extent = context.targets.extent(),
                                               .within = context.drawn});
}

void record_opaque(const PassContext& context) {
  const SceneTargets scene(context.graph);
  if (context.graph.ground_behind) clear_around_meshes(context);
  if (scene.sampled) record_depth_samples(context);
  const bool depth_is_there = scene.sampled || context.graph.has(Pass::normal_depth);
  if (!depth_is_there) context.targets.next_use(context.commands, scene.depth, kWriteDepth, false);
  Attachments attachments{.depth = context.targets.view(scene.depth),
                          .depth_write = !depth_is_there,
                          .extent = context.targets.extent(),
                          .within = context.meshes};
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
                          .extent = context.targets.extent(),
                          .within = context.meshes};
  attach_colors(context, pass, true, attachments);
  return attachments;
}

void record_outline(const PassContext& context) {
  const Rendering rendering(context.commands, over_opaque(context, Pass::outline));
  vkCmdSetScissor(context.commands, 0, 1, &context.outlined);
  draw_screen(context, context.pipelines.screen({.pass = Pass::outline, .frame = context.features}), context.set.set());
}

void record_ground(const PassContext& context) {
  if (context.graph.ground_behind) {
    context.targets.next_use(context.commands, Target::color, kWriteColor);
    const Rendering rendering(context.commands, {.color = context.targets.view(Target::color),
                                                 .load = VK_ATTACHMENT_LOAD_OP_LOAD,
                                                 .extent = context.targets.extent(),
                                                 .within = context.drawn});
    return draw_ground(context, Pass::ground);
  }
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
                 .extent = context.targets.extent(),
                 .within = context.meshes};
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
    case Pass::backdrop: return record_backdrop(context);
    case Pass::tonemap: return record_tonemap(context);
    case Pass::show: return record_show(context);
    case Pass::overlay: return record_overlay(context);
  }
}

}  // namespace sinew::viewer
