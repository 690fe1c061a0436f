// SPDX-License-Identifier: MIT
// A renderer that has drawn with other options gives the same pictures and reports as a fresh one.
#include "samples/showcase/shapes.h"
#include "tests/viewer/device_fixture.h"
#include "viewer/app/headless.h"
#include "viewer/app/live_plan.h"

namespace sinew::viewer {
namespace {

class renderer_state : public DeviceTest {};

/// Opaque, blended, unlit and rough glass, in the light of three spot lights.
BuiltScene all_kinds() {
  BuiltScene built = box_and_sphere_on_floor();
  Material pane = matte({0.3f, 0.8f, 0.4f}), glass = matte({0.8f, 0.9f, 1.0f}), sign = matte({1.0f, 0.5f, 0.0f});
  pane.alpha_mode = AlphaMode::blend;
  pane.base_color.a = 0.5f;
  pane.double_sided = true;
  glass.transmission.factor = 0.8f;
  sign.unlit = true;
  built.add(square(0.7f), built.add_material(pane), translation({0.2f, 1.3f, 0.3f}));
  built.add(showcase::sphere({0.9f, 0.5f, 1.2f}, 0.3f, 12, 8), built.add_material(glass));
  built.add(showcase::sphere({-1.1f, 0.4f, 0.9f}, 0.25f, 12, 8), built.add_material(sign));
  for (const float x : {-1.5f, 0.5f, 2.0f}) {
    Affine from_above = translation({x, 4.0f, 0.5f});  // shines along -y
    from_above.row[1] = {0.0f, 0.0f, 1.0f, 4.0f};
    from_above.row[2] = {0.0f, -1.0f, 0.0f, 0.5f};
    built.add_light({.kind = Light::Kind::spot, .intensity = 6.0f}, from_above);
  }
  return built;
}

struct Way {
  const char* what;
  RenderOptions options;
  std::size_t lights = 3;  ///< lights of the scene that are not hidden
  bool sign = true;        ///< the unlit one is not hidden
};

std::vector<Way> ways() {
  RenderOptions plain;
  plain.shadows = {true, {glm::vec3(-3.0f), glm::vec3(3.0f)}};
  plain.ground = ground_for({{-2, 0, -2}, {2, 2, 2}});
  RenderOptions gooch = plain, smooth = plain, automatic = plain, evening = plain, alone = plain;
  gooch.shading = Shading::gooch;
  smooth.smooth_edges = true;
  smooth.transparency = Transparency::weighted;
  smooth.ground.look = GroundLook::grid;
  automatic.lighting.auto_exposure = true;
  automatic.backdrop = Backdrop::sharp;
  evening.lighting.environment = gradient_environment({.sky = {0.9f, 0.3f, 0.1f}});
  alone.ao.on = alone.shadows.on = false;
  alone.lighting.environment = nullptr;
  return {{"one light", plain, 1},
          {"three lights", plain},
          {"weighted, smooth", smooth},
          {"one light after three", plain, 1, false},
          {"gooch", gooch},
          {"automatic exposure", automatic, 2},
          {"another environment", evening},
          {"nothing besides", alone},
          {"one light again", plain, 1}};
}

/// The frame for a set of options. It refers to the arguments.
FrameResult frame_of(const BuiltScene& built, const Way& way, std::vector<char>& hidden,
                     std::vector<InstanceResult>& instances) {
  FrameResult frame = built.frame();
  hidden.assign(frame.model.size(), 0);
  for (std::size_t i = way.lights; i < built.scene.lights.size(); ++i) hidden[built.scene.lights[i].joint] = 1;
  frame.hidden = {reinterpret_cast<const bool*>(hidden.data()), hidden.size()};
  instances.assign(frame.instances.begin(), frame.instances.end());
  instances.back().visible = way.sign;
  hidden[built.scene.instances.back().joint] = !way.sign;
  frame.instances = instances;
  return frame;
}

/// The live plan's text of a frame, without times, and without the shadow maps that a used renderer may keep.
std::string told(FrameReport report) {
  report.passes[static_cast<std::size_t>(Pass::shadow)] = {};
  report.collect_us = 0.0;
  LivePlan live;
  live.drawn({}, report, {});
  return plan_text(live.rows());
}

TEST_F(renderer_state, what_was_drawn_before_leaves_nothing_behind) {
  const BuiltScene built = all_kinds();
  const View view = look_at({2.5, 2.2, 4.0}, {0.0, 0.4, 0.0}, 0.8, 0.05);
  Headless used(*test_device(), built.scene, 32, 24);
  std::vector<char> hidden;
  std::vector<InstanceResult> instances;
  for (const Way& way : ways()) {
    const FrameResult frame = frame_of(built, way, hidden, instances);
    Headless fresh(*test_device(), built.scene, 32, 24);
    EXPECT_EQ(used.render(frame, view, way.options).rgba, fresh.render(frame, view, way.options).rgba) << way.what;
    EXPECT_EQ(told(used.report()), told(fresh.report())) << way.what;
  }
}

}  // namespace
}  // namespace sinew::viewer
