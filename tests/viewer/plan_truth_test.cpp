// SPDX-License-Identifier: MIT
// The plan of a picture tells no untruth: without a pass that is on, the picture is another one. A pass that is off has
// no count.
#include <algorithm>
#include <functional>
#include <optional>

#include "samples/showcase/shapes.h"
#include "tests/viewer/device_fixture.h"
#include "viewer/app/headless.h"
#include "viewer/light/rooms.h"

namespace sinew::viewer {
namespace {

class plan_truth : public DeviceTest {};

constexpr std::uint32_t kWidth = 72, kHeight = 54;

/// A picture's inputs.
struct Case {
  const char* what = "";
  RenderOptions options;
  View view = look_at({2.5, 2.2, 4.0}, {0.0, 0.4, 0.0}, 0.8, 0.05);
  std::vector<LineVertex> lines;
  bool solid = true;                ///< opaque instances are shown
  bool pane = false, sign = false;  ///< so are those that blend, and those that are rough and let light through
};

/// A box and a ball; a pane that blends; frosted glass.
BuiltScene scene_of(const Case& shown) {
  BuiltScene built;
  const std::uint32_t grey = built.add_material(matte({0.6f, 0.6f, 0.6f}));
  if (shown.solid) {
    built.add(showcase::box({0, 0, 0}, glm::vec3(0.4f)), grey, translation({-0.3f, 0.4f, 0.0f}));
    built.add(showcase::sphere({0, 0, 0}, 0.3f, 24, 16), grey, translation({0.45f, 0.3f, 0.4f}));
  }
  Material pane = matte({0.3f, 0.8f, 0.4f}), frosted = matte({0.8f, 0.9f, 1.0f});
  pane.alpha_mode = AlphaMode::blend;
  pane.base_color.a = 0.5f;
  frosted.transmission.factor = 0.8f;
  if (shown.pane) built.add(square(0.5f), built.add_material(pane), translation({0.2f, 1.1f, 0.3f}));
  if (shown.sign) built.add(showcase::sphere({0.2f, 0.8f, 0.9f}, 0.3f, 12, 8), built.add_material(frosted));
  return built;
}

Case plain(const char* what) {
  const Aabb bounds{{-0.7f, 0.0f, -0.4f}, {0.8f, 0.8f, 0.7f}};
  Case made{what, render_options_for(bounds, {0, 0, 5}), {}, {}};
  made.view = look_at({2.5, 2.2, 4.0}, {0.0, 0.4, 0.0}, 0.5, 0.05);
  made.options.lighting.use(room_environment(Room::studio));
  made.options.lighting.tone_curve = ToneCurve::aces;
  made.options.backdrop = Backdrop::blurred;
  made.options.smooth_edges = true;
  made.options.shadows = {true, bounds};
  made.options.ground.look = GroundLook::shadows;
  made.options.ao.radius_m = 0.4f;
  return made;
}

std::vector<Case> cases() {
  std::vector<Case> all;
  const auto add = [&](const char* what, const std::function<void(Case&)>& change) {
    all.push_back(plain(what));
    change(all.back());
  };
  add("as by default", [](Case&) {});
  add("one sample a pixel", [](Case& c) { c.options.smooth_edges = false; });
  add("sharp backdrop", [](Case& c) { c.options.backdrop = Backdrop::sharp; });
  add("plain backdrop", [](Case& c) { c.options.backdrop = Backdrop::plain; });
  add("transparent", [](Case& c) { c.options.transparent_background = true; });
  add("no shadows", [](Case& c) { c.options.shadows.on = false; });
  add("no occlusion", [](Case& c) { c.options.ao.on = false; });
  add("neither", [](Case& c) { c.options.ao.on = c.options.shadows.on = false; });
  add("overcast", [](Case& c) { c.options.lighting.use(room_environment(Room::overcast)); });
  add("no environment", [](Case& c) { c.options.lighting.environment = nullptr; });
  add("a grid", [](Case& c) { c.options.ground.look = GroundLook::grid; });
  add("no ground", [](Case& c) { c.options.ground.look = GroundLook::none; });
  add("from below", [](Case& c) { c.view = look_at({2.5, -1.2, 4.0}, {0.0, 0.4, 0.0}, 0.5, 0.05); });
  add("gooch", [](Case& c) { c.options.shading = Shading::gooch; });
  add("automatic exposure", [](Case& c) { c.options.lighting.auto_exposure = true; });
  add("a pane", [](Case& c) { c.pane = true; });
  add("a pane in any order", [](Case& c) {
    c.pane = true;
    c.options.transparency = Transparency::weighted;
  });
  add("frosted glass", [](Case& c) { c.sign = true; });
  add("lines", [](Case& c) { c.lines = {{{-1, 0, 0}}, {{1, 1, 0}}}; });
  add("nothing", [](Case& c) { c.solid = false; });
  for (const Show show : {Show::ao, Show::normals, Show::depth})
    add("a buffer", [show](Case& c) { c.options.show = show; });
  return all;
}

/// The same case without a pass, by what asks for it. Empty if other passes need it, or if it is the picture itself.
std::optional<Case> without(Case shown, Pass pass) {
  switch (pass) {
    case Pass::shadow: shown.options.shadows.on = false; break;
    case Pass::ssao: shown.options.ao.on = false; break;
    case Pass::blur_horizontal:
    case Pass::blur_vertical: shown.options.ao.blur = false; break;
    case Pass::ground: shown.options.ground.look = GroundLook::none; break;
    case Pass::backdrop: shown.options.backdrop = Backdrop::plain; break;
    case Pass::exposure: shown.options.lighting.auto_exposure = false; break;
    case Pass::outline: shown.options.shading = Shading::physical; break;
    case Pass::overlay: shown.lines.clear(); break;
    case Pass::behind: shown.sign = false; break;
    case Pass::transparent:
    case Pass::weighted: shown.pane = shown.sign = false; break;
    case Pass::opaque: shown.solid = shown.pane = shown.sign = false; break;
    default: return std::nullopt;
  }
  return shown;
}

Picture picture_of(const Case& shown, FrameReport* report = nullptr, std::vector<std::string>* timed = nullptr) {
  const BuiltScene built = scene_of(shown);
  Headless pictures(*test_device(), built.scene, kWidth, kHeight);
  Picture picture = pictures.render(built.frame(), shown.view, shown.options, shown.lines);
  if (report) *report = pictures.report();
  if (timed)
    for (const PassTime& time : pictures.pass_times()) timed->emplace_back(time.pass);
  return picture;
}

TEST_F(plan_truth, a_pass_that_is_on_changes_the_picture_and_one_that_is_off_takes_nothing) {
  for (const Case& shown : cases()) {
    FrameReport report;
    std::vector<std::string> timed;
    const Picture picture = picture_of(shown, &report, &timed);
    for (const PassStage& stage : report.passes) {
      const bool ran = std::find(timed.begin(), timed.end(), name_of(stage.pass)) != timed.end();
      if (!timed.empty()) {
        EXPECT_EQ(stage.runs, ran) << shown.what << ": " << name_of(stage.pass);
      }
      EXPECT_EQ(stage.count > 0, stage.runs) << shown.what << ": " << name_of(stage.pass);
      const auto other = stage.runs ? without(shown, stage.pass) : std::nullopt;
      if (!other) continue;
      EXPECT_NE(picture.rgba, picture_of(*other).rgba)
          << shown.what << ": " << name_of(stage.pass) << " changes nothing";
    }
  }
}

}  // namespace
}  // namespace sinew::viewer
