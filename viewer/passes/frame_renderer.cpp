// SPDX-License-Identifier: MIT
#include "viewer/passes/frame_renderer.h"

#include <algorithm>
#include <chrono>
#include <cstring>

#include "runtime/base/contract.h"
#include "viewer/device/timestamps.h"
#include "viewer/passes/ground_reach.h"
#include "viewer/passes/record_display.h"
#include "viewer/passes/record_passes.h"
#include "viewer/passes/shadow_key.h"

namespace sinew::viewer {

namespace {

constexpr float kPointPixels = 4.0f;

struct ViewLineVertex {
  glm::vec3 view_position;
  std::uint32_t rgba;
};
static_assert(sizeof(ViewLineVertex) == 16);

/// Resources of one frame in flight.
struct FrameSlot {
  FrameSlot(const Device& device, const PassLayouts& layouts)
      : set(device, layouts), timestamps(device, kPassCount + 1) {}

  FrameSet set;
  Timestamps timestamps;
  Buffer lines;
  std::vector<Pass> passes;  ///< passes of its last frame
  std::vector<PassTime> times;
  FrameReport report;
};

}  // namespace

struct FrameRenderer::State {
  State(Device& used, VkFormat target_format, std::uint32_t slot_count, const OcclusionShape& occlusion)
      : device(used),
        layouts(used),
        pipelines(used, layouts, target_format, occlusion),
        targets(used, occlusion.step),
        kernel(make_ssao_kernel(occlusion.samples)),
        environment(used) {
    for (std::uint32_t i = 0; i < slot_count; ++i) slots.push_back(std::make_unique<FrameSlot>(used, layouts));
  }

  void upload_lines(FrameSlot& slot, const FrameInputs& inputs) const;
  void collect_lights(const FrameInputs& inputs);
  void keep_shadows(const FrameInputs& inputs, const ShadowLights& shadows, VkExtent2D extent, FrameNeeds& needs);

  Device& device;
  PassLayouts layouts;
  PassPipelines pipelines;
  FrameTargets targets;
  SsaoKernel kernel;
  DrawList draws;
  std::vector<PlacedLight> lights;
  EnvironmentUpload environment;
  ShadowKey shadow_key;
  std::vector<ShadowView> shadow_views;
  std::vector<std::unique_ptr<FrameSlot>> slots;
};

FrameRenderer::FrameRenderer(Device& device, VkFormat target_format, std::uint32_t slot_count,
                             const OcclusionShape& occlusion)
    : state_(std::make_unique<State>(device, target_format, slot_count, occlusion)) {}

FrameRenderer::~FrameRenderer() {
  vkDeviceWaitIdle(state_->device.handle());  // result ignored: a destructor must not throw
}

void FrameRenderer::State::upload_lines(FrameSlot& slot, const FrameInputs& inputs) const {
  const VkDeviceSize bytes = inputs.lines.size() * sizeof(ViewLineVertex);
  if (bytes == 0) return;
  if (slot.lines.size() < bytes)
    slot.lines = Buffer(device, bytes, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, MemoryUse::upload);
  std::byte* at = slot.lines.mapped();
  for (const LineVertex& vertex : inputs.lines) {
    const ViewLineVertex moved{glm::vec3(transform_point(inputs.view.view_from_world, glm::dvec3(vertex.position))),
                               vertex.rgba};
    std::memcpy(at, &moved, sizeof(moved));
    at += sizeof(moved);
  }
}

void FrameRenderer::State::collect_lights(const FrameInputs& inputs) {
  lights.clear();
  for (const DrawnScene& drawn : inputs.scenes) {
    const FrameVertices& frame = drawn.frame->vertices(inputs.slot);
    for (std::size_t i = 0; i < frame.world_from_light.size(); ++i)
      if (frame.light_shines[i]) lights.push_back({&frame.look.lights[i], frame.world_from_light[i]});
  }
}

namespace {

bool is_gooch(const FrameInputs& inputs) { return inputs.options.shading == Shading::gooch; }

/// True if the environment is read as light or as backdrop. Gooch shading uses it only as backdrop.
bool reads_environment(const FrameInputs& inputs) {
  return inputs.options.lighting.ambient() && (!is_gooch(inputs) || inputs.options.backdrop != Backdrop::plain);
}

FrameFeatures features_of(const FrameInputs& inputs, const FrameGraph& graph, std::span<const PlacedLight> lights,
                          const ShadowLights& shadows) {
  return {.occluded = graph.ao_image,
          .bent = graph.bent_normals,
          .vertex_visibility = graph.vertex_visibility,
          .parallel = inputs.view.parallel(),
          .transparent_background = inputs.options.transparent_background,
          .ambient = inputs.options.lighting.ambient() && !is_gooch(inputs),
          .shadow_lights = graph.shadow_maps > 0 ? shadows.mask() : 0,
          .tone_curve = inputs.options.lighting.tone_curve,
          .backdrop = inputs.options.lighting.ambient() ? inputs.options.backdrop : Backdrop::plain,
          .auto_exposure = graph.exposure_image,
          .unlit_image = graph.unlit_image,
          .weighted = graph.weighted_images,
          .gooch = is_gooch(inputs),
          .shows_level = inputs.options.show == Show::level,
          .quaternion_normals = inputs.options.normals == NormalInterpolation::quaternion,
          .smooth_edges = graph.sampled,
          .light_count = light_count(inputs.options, lights)};
}

/// Parts of the picture that passes are limited to; see PassContext.
struct ScreenAreas {
  VkRect2D occluded, drawn, meshes, contact, outlined;
};

std::uint64_t pixels_of(const VkRect2D& area) noexcept { return std::uint64_t{area.extent.width} * area.extent.height; }

/// Adds a rectangle of the ground.
void add_ground(const FrameUniforms& uniforms, const glm::vec4& rectangle, CoveredArea& area) {
  for (const float x : {rectangle.x, rectangle.z})
    for (const float z : {rectangle.y, rectangle.w})
      area.add_point(glm::dvec3(uniforms.ground_middle + uniforms.ground_x * x + uniforms.ground_z * z));
}

/// At least one pixel, because the driver takes no empty area.
VkRect2D not_empty(VkRect2D area) noexcept {
  return area.extent.width > 0 && area.extent.height > 0 ? area : VkRect2D{{0, 0}, {1, 1}};
}

ScreenAreas areas_of(const DrawList& draws, const FrameGraph& graph, const FrameUniforms& uniforms,
                     const CoveredArea& nothing, VkExtent2D extent, std::uint32_t ao_step) {
  CoveredArea occluded = draws.opaque_area(), meshes = draws.drawn_area(), drawn = meshes, contact = nothing;
  if (graph.ground_occluded) {
    add_ground(uniforms, uniforms.ground_contact, contact);
    add_ground(uniforms, uniforms.ground_contact, occluded);
  }
  if (graph.has(Pass::ground)) add_ground(uniforms, uniforms.ground_reach, drawn);
  if (graph.exposure_image || graph.behind_image) drawn.add_everything();  // these passes read the whole picture
  return {occluded.texels(extent, ao_step), not_empty(drawn.texels(extent, 1)),
          not_empty((graph.ground_behind && !graph.exposure_image ? meshes : drawn).texels(extent, 1)),
          not_empty(contact.texels(extent, 1)), not_empty(draws.opaque_area().texels(extent, 1))};
}

FrameReport report_of(const DrawList& draws, const FrameNeeds& needs, const FrameInputs& inputs, VkExtent2D extent,
                      const ScreenAreas& areas, double collect_us) {
  const auto opaque = static_cast<std::uint32_t>(draws.opaque().size()),
             blended = static_cast<std::uint32_t>(draws.blended().size()),
             weighted = static_cast<std::uint32_t>(draws.weighted().size());
  const PassWork work{.caster_draws = needs.shadows * static_cast<std::uint32_t>(draws.casters().size()),
                      .opaque_draws = opaque,
                      .blended_draws = blended,
                      .weighted_draws = weighted,
                      .lines = static_cast<std::uint32_t>(inputs.lines.size() / 2),
                      .extent = extent,
                      .ao_texels = pixels_of(areas.occluded),
                      .drawn_pixels = pixels_of(areas.drawn),
                      .outline_pixels = pixels_of(areas.outlined)};
  const TextureFilter filter = inputs.scenes.empty() ? TextureFilter{} : inputs.scenes.front().scene->filter();
  return {describe_passes(needs, work),
          describe_modes(needs, inputs.options, filter),
          opaque + blended + weighted,
          draws.out_of_view(),
          draws.hidden(),
          collect_us};
}

/// Near distance and 1 / depth of the range for weights. With no depth, the factor 0 gives all surfaces the same
/// weight.
glm::vec2 weighted_range(const DepthRange& range) {
  const float depth_m = range.farthest_m - range.nearest_m;
  return {range.nearest_m, depth_m > 0.0f ? 1.0f / depth_m : 0.0f};
}

/// The ground that a frame draws: what of it, or why none.
struct FrameGround {
  bool drawn = false;
  NoGround reason = NoGround::not_asked;
  GroundReach reach;
};

/// True if a rectangle of the ground may be in view.
bool ground_is_in_view(const glm::vec4& reach, const FrameInputs& inputs, double aspect) {
  const glm::vec3 middle(inputs.options.ground.middle);
  const Aabb flat{middle + glm::vec3(reach.x, 0.0f, reach.y), middle + glm::vec3(reach.z, 0.0f, reach.w)};
  return !is_out_of_view(inputs.view, aspect, inputs.view.view_from_world, flat);
}

FrameGround ground_of(const DrawList& draws, const FrameInputs& inputs, const ShadowLights& shadows, double aspect) {
  const RenderOptions& options = inputs.options;
  const bool gooch = is_gooch(inputs), grid = options.ground.look == GroundLook::grid;
  if ((gooch && !grid) || !ground_is_seen(inputs.view, options.ground)) return {};
  const bool touches = options.ao.in_screen_space() && options.lighting.ambient() && !gooch && !draws.opaque().empty();
  const GroundReach reach =
      ground_reach(options.ground, draws.standing(), draws.casters().empty() ? ShadowLights{} : shadows,
                   touches ? static_cast<double>(options.ao.radius_m) : 0.0);
  if (!grid && (!reach.darkened || !ground_is_in_view(reach.rectangle, inputs, aspect)))
    return {false, NoGround::nothing_darkens, {}};
  return {true, NoGround::not_asked, reach};
}

bool shows_environment(const FrameInputs& inputs) {
  return inputs.options.lighting.ambient() && inputs.options.backdrop != Backdrop::plain &&
         !inputs.options.transparent_background;
}

FrameNeeds needs_of(const DrawList& draws, const FrameInputs& inputs, const ShadowLights& shadows,
                    const FrameGround& ground) {
  const bool gooch = is_gooch(inputs),
             visible = !draws.opaque().empty() || !draws.blended().empty() || !draws.weighted().empty();
  const bool grid = inputs.options.ground.look == GroundLook::grid;
  return {.opaque = !draws.opaque().empty(),
          .blended = !draws.blended().empty(),
          .frosted = std::ranges::any_of(draws.blended(), &Draw::frosted),
          .weighted = !draws.weighted().empty(),
          .overlay = !inputs.lines.empty() || inputs.overlay,
          .lines = !inputs.lines.empty(),
          .unlit = draws.unlit() || (gooch && visible),
          .gooch = gooch,
          .shadows = draws.casters().empty() ? 0 : shadows.count(),
          .ambient = inputs.options.lighting.ambient() && !gooch,
          .occlusion = inputs.options.ao.in_screen_space(),
          .horizons = inputs.options.ao.method == OcclusionMethod::gtao,
          .baked = inputs.options.ao.at_vertices(),
          .blur = inputs.options.ao.blur,
          .auto_exposure = inputs.options.lighting.auto_exposure && !gooch,
          .ground = ground.drawn,
          .ground_touched = ground.reach.contact.x < ground.reach.contact.z,
          .no_ground = ground.reason,
          .grid = ground.drawn && grid,
          .smooth_edges = inputs.options.smooth_edges,
          .backdrop = shows_environment(inputs),
          .show = inputs.options.show};
}

}  // namespace

/// Decides if the shadow maps of the last frame still hold.
void FrameRenderer::State::keep_shadows(const FrameInputs& inputs, const ShadowLights& shadows, VkExtent2D extent,
                                        FrameNeeds& needs) {
  shadow_views.clear();
  if (!needs.shadowed()) return shadow_key.forget();
  for (const ShadowLight& light : shadows) shadow_views.push_back(shadow_view_of(light, inputs.options.shadows.bounds));
  needs.shadows_kept = shadow_key.holds(shadow_views, draws.casters(), extent);
}

void FrameRenderer::record(VkCommandBuffer commands, const ColorTarget& target, const FrameInputs& inputs) {
  CONTRACT(inputs.slot < state_->slots.size() && target.extent.width > 0 && target.extent.height > 0);
  State& state = *state_;
  FrameSlot& slot = *state.slots[inputs.slot];
  const double aspect = static_cast<double>(target.extent.width) / target.extent.height;
  const auto start = std::chrono::steady_clock::now();
  state.collect_lights(inputs);
  const ShadowLights shadows =
      is_gooch(inputs) ? ShadowLights{} : shadow_lights(inputs.view, inputs.options, state.lights);
  const bool casters = shadows.count() > 0 && inputs.options.show == Show::color;
  state.draws.collect(inputs.scenes, inputs.slot, inputs.view, aspect,
                      std::min(kPointPixels, state.device.max_point_size()), casters, inputs.options.transparency);
  const double collect_us = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
  const FrameGround ground = ground_of(state.draws, inputs, shadows, aspect);
  FrameNeeds needs = needs_of(state.draws, inputs, shadows, ground);
  state.keep_shadows(inputs, shadows, target.extent, needs);
  const FrameGraph graph(needs);
  state.targets.fit(graph, target.extent);
  const bool occlusion = graph.ao_image;
  if (reads_environment(inputs)) state.environment.show(inputs.options.lighting.environment);
  if (state.draws.reads_table() && !is_gooch(inputs)) state.environment.show_table();
  FrameUniforms uniforms =
      make_frame_uniforms(inputs.view, target.extent, inputs.options, occlusion, state.lights, shadows, state.kernel);
  if (ground.drawn) {
    uniforms.ground_reach = ground.reach.rectangle;
    uniforms.ground_contact = ground.reach.contact;
  }
  uniforms.weighted_range = weighted_range(state.draws.weighted_range());
  const ScreenAreas areas =
      areas_of(state.draws, graph, uniforms, CoveredArea(inputs.view, aspect), target.extent, state.targets.ao_step());
  slot.report = report_of(state.draws, needs, inputs, target.extent, areas, collect_us);
  slot.set.write(uniforms, state.targets, state.environment, graph.has(Pass::normal_depth));
  state.upload_lines(slot, inputs);

  const PassContext context{commands,
                            graph,
                            state.targets,
                            state.pipelines,
                            state.layouts.pipeline(),
                            slot.set,
                            state.draws,
                            inputs,
                            target,
                            features_of(inputs, graph, state.lights, shadows),
                            state.shadow_views,
                            areas.occluded,
                            areas.drawn,
                            areas.meshes,
                            areas.contact,
                            areas.outlined,
                            slot.lines.handle(),
                            static_cast<std::uint32_t>(inputs.lines.size())};
  // The submit waits for the target's semaphore at the COLOR_ATTACHMENT_OUTPUT stage; this barrier chains to that wait.
  barrier(commands, target.image, VK_IMAGE_ASPECT_COLOR_BIT, {VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT},
          kWriteColor);
  if (needs.show == Show::color && !graph.has(Pass::backdrop) && !graph.has(Pass::tonemap)) clear_target(context);
  slot.timestamps.begin(commands);
  slot.passes.assign(graph.begin(), graph.end());
  for (const Pass pass : graph) {
    record_pass(pass, context);
    slot.timestamps.mark(commands);
  }
  barrier(commands, target.image, VK_IMAGE_ASPECT_COLOR_BIT, kWriteColor,
          {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT, target.final_layout});
}

std::span<const PassTime> FrameRenderer::pass_times(std::uint32_t slot_index) {
  FrameSlot& slot = *state_->slots[slot_index];
  const std::vector<double> spans = slot.timestamps.milliseconds();
  slot.times.clear();
  for (std::size_t i = 0; i < spans.size(); ++i) slot.times.push_back({name_of(slot.passes[i]), spans[i]});
  return slot.times;
}

const FrameReport& FrameRenderer::report(std::uint32_t slot) const { return state_->slots[slot]->report; }

}  // namespace sinew::viewer
