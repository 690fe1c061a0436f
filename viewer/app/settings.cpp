// SPDX-License-Identifier: MIT
#include "viewer/app/settings.h"

#include <cmath>
#include <utility>

#include <glm/trigonometric.hpp>

#include "viewer/app/motion/layer_choice.h"
#include "viewer/app/scene_choice.h"

namespace sinew::viewer {

Settings settings_from(const Options& options, const Scene& scene) {
  Settings settings;
  settings.show = options.show;
  settings.shading = options.shading;
  settings.normals = options.normals;
  settings.transparency = options.transparency;
  settings.ambient_occlusion = options.ambient_occlusion;
  settings.occlusion_method = options.occlusion_method;
  settings.environment_turn_deg = options.environment_turn_deg;
  settings.environment_intensity = options.environment_intensity;
  settings.exposure_ev = options.exposure_ev;
  settings.auto_exposure = options.auto_exposure;
  settings.shadows = options.shadows;
  settings.ground = options.ground;
  settings.smooth_edges = options.smooth_edges.value_or(true);
  settings.backdrop =
      options.backdrop.value_or(options.shading == Shading::gooch ? Backdrop::plain : Backdrop::blurred);
  settings.tone_curve = options.tone_curve;
  settings.skinning = options.skinning;
  settings.framing = options.framing;
  settings.cache_weight = options.cache_weight;
  settings.updates = options.updates.value_or(options.headless.empty() ? Updates::interpolated : Updates::every);
  settings.skeleton = options.skeleton || scene.instances.empty();
  if (options.file_camera) settings.camera = choose_camera(scene, *options.file_camera).value_or(kNone);
  settings.motion.mirrored = options.mirrored;
  settings.motion.root = options.root;
  settings.motion.springs = options.springs;
  settings.motion.fade_s = options.fade_s;
  settings.motion.layers = find_layers(options.layers, scene).value_or(std::vector<LayerSetting>());
  settings.inspected = options.inspected;
  if (options.joint) settings.inspected.joint = choose_joint(scene, *options.joint).value_or(kNone);
  if (options.variant) settings.variant = choose_variant(scene, *options.variant).value_or(kNone);
  return settings;
}

void Settings::leave_scene() {
  camera = variant = inspected.joint = kNone;
  inspected.vertex = {};
  if (inspected.paint == Paint::weights) inspected.paint = Paint::materials;
  motion.layers.clear();
  motion.expressions.clear();
  motion.morph_weights.clear();
}

void toggle_ao_only(Settings& settings) noexcept {
  settings.show = settings.show == Show::ao ? Show::color : Show::ao;
  // With occlusion off the picture would be plain white.
  if (settings.show == Show::ao) settings.ambient_occlusion = true;
}

void toggle_plan(Settings& settings) noexcept {
  settings.plan = !settings.shows_plan();
  if (settings.plan) settings.panel = true;
}

void toggle_inside(Settings& settings) noexcept {
  settings.inside = !(settings.panel && settings.inside);
  if (settings.inside) settings.panel = true;
}

void toggle_keys(Settings& settings) noexcept {
  settings.timeline_keys = !(settings.panel && settings.timeline_keys);
  if (settings.timeline_keys) settings.panel = true;
}

void next_updates(Settings& settings) noexcept {
  switch (settings.updates) {
    case Updates::every: settings.updates = Updates::interpolated; break;
    case Updates::interpolated: settings.updates = Updates::held; break;
    case Updates::held: settings.updates = Updates::every; break;
  }
}

void next_skinning(Settings& settings) noexcept {
  switch (settings.skinning) {
    case Skinning::linear: settings.skinning = Skinning::dual_quaternion; break;
    case Skinning::dual_quaternion: settings.skinning = Skinning::center_of_rotation; break;
    case Skinning::center_of_rotation: settings.skinning = Skinning::linear; break;
  }
}

void next_ground(Settings& settings) noexcept {
  switch (settings.ground) {
    case GroundLook::none: settings.ground = GroundLook::shadows; break;
    case GroundLook::shadows: settings.ground = GroundLook::grid; break;
    case GroundLook::grid: settings.ground = GroundLook::none; break;
  }
}

void next_show(Settings& settings) noexcept {
  switch (settings.show) {
    case Show::color: settings.show = Show::ao; break;
    case Show::ao: settings.show = Show::normals; break;
    case Show::normals: settings.show = Show::depth; break;
    case Show::depth: settings.show = Show::level; break;
    case Show::level: settings.show = Show::color; break;
  }
}

RenderOptions render_options(const Settings& settings, std::shared_ptr<const Environment> environment,
                             const ClipExtent& bounds, const glm::dvec3& eye) {
  RenderOptions options = render_options_for(bounds.reached, eye);
  options.ao = ambient_occlusion_for(bounds.largest);
  options.ao.on = settings.ambient_occlusion;
  options.ao.method = settings.occlusion_method;
  options.show = settings.show;
  options.shading = settings.shading;
  options.normals = settings.normals;
  options.transparency = settings.transparency;
  options.lighting.use(std::move(environment));
  options.lighting.environment_intensity = settings.environment_intensity;
  options.lighting.environment_turn_rad = glm::radians(settings.environment_turn_deg);
  options.shadows = {settings.shadows, bounds.reached};
  options.ground.look = settings.ground;
  options.smooth_edges = settings.smooth_edges;
  options.backdrop = settings.backdrop;
  options.lighting.tone_curve = settings.tone_curve;
  options.lighting.auto_exposure = settings.auto_exposure;
  options.lighting.exposure = std::exp2(settings.exposure_ev);
  return options;
}

}  // namespace sinew::viewer
