// SPDX-License-Identifier: MIT
// Each command-line option changes exactly one field of the renderer's options.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "viewer/app/settings.h"

namespace sinew::viewer {
namespace {

Options parsed(const std::string& words) {
  std::vector<std::string> list = {"sinew-viewer"};
  std::istringstream in(words);
  for (std::string word; in >> word;) list.push_back(word);
  std::vector<const char*> argv;
  for (const std::string& word : list) argv.push_back(word.c_str());
  const auto result = parse_options(static_cast<int>(argv.size()), argv.data());
  EXPECT_TRUE(std::holds_alternative<Options>(result)) << words;
  return std::get<Options>(result);
}

template <class Value>
double number(Value value) {
  return static_cast<double>(value);
}

using Fields = std::map<std::string, double>;

/// All fields that depend on the command line, by name.
Fields fields_of(const std::string& words) {
  Scene scene;
  scene.instances.emplace_back();
  scene.cameras = {{.name = "front", .joint = 0}, {.name = "side", .joint = 0}};
  scene.variants = {"day", "night"};
  ClipExtent extent;
  extent.reached.add({-2, 0, -1});
  extent.reached.add({6, 2, 1});
  extent.largest.add({-1, 0, -1});
  extent.largest.add({1, 2, 1});
  const Settings settings = settings_from(parsed(words), scene);
  const RenderOptions o = render_options(settings, plain_environment(), extent, {0, 0, 9});
  EXPECT_EQ(o.lighting.environment, plain_environment());
  EXPECT_EQ(o.shadows.bounds.upper, extent.reached.upper);
  EXPECT_EQ(o.ground.bounds.upper, extent.reached.upper);
  EXPECT_EQ(o.ao.radius_m, ambient_occlusion_for(extent.largest).radius_m);
  return {{"show", number(o.show)},
          {"shading", number(o.shading)},
          {"normals", number(o.normals)},
          {"transparency", number(o.transparency)},
          {"ao", number(o.ao.on)},
          {"ao method", number(o.ao.method)},
          {"environment intensity", number(o.lighting.environment_intensity)},
          {"environment turn", number(o.lighting.environment_turn_rad)},
          {"exposure", number(o.lighting.exposure)},
          {"auto exposure", number(o.lighting.auto_exposure)},
          {"tone curve", number(o.lighting.tone_curve)},
          {"shadows", number(o.shadows.on)},
          {"ground", number(o.ground.look)},
          {"smooth edges", number(o.smooth_edges)},
          {"backdrop", number(o.backdrop)},
          {"skinning", number(settings.skinning)},
          {"updates", number(settings.updates)},
          {"framing", number(settings.framing)},
          {"camera", number(settings.camera)},
          {"variant", number(settings.variant)},
          {"cache weight", number(settings.cache_weight)},
          {"skeleton", number(settings.skeleton)},
          {"panel", number(settings.panel)},
          {"plan", number(settings.plan)}};
}

Fields without_any() {
  return {{"show", number(Show::color)},
          {"shading", number(Shading::physical)},
          {"normals", number(NormalInterpolation::interpolated)},
          {"transparency", number(Transparency::sorted)},
          {"ao", 1.0},
          {"ao method", number(OcclusionMethod::gtao)},
          {"environment intensity", 1.0},
          {"environment turn", 0.0},
          {"exposure", 1.0},
          {"auto exposure", 0.0},
          {"tone curve", number(ToneCurve::aces)},
          {"shadows", 1.0},
          {"ground", number(GroundLook::shadows)},
          {"smooth edges", 1.0},
          {"backdrop", number(Backdrop::blurred)},
          {"skinning", number(Skinning::linear)},
          {"updates", number(Updates::interpolated)},
          {"framing", number(Framing::clip)},
          {"camera", number(kNone)},
          {"variant", number(kNone)},
          {"cache weight", 1.0},
          {"skeleton", 0.0},
          {"panel", 1.0},
          {"plan", 0.0}};
}

struct Effect {
  const char* words;
  Fields changed;
};

const Effect kEffects[] = {
    {"", {}},
    {"--show ao", {{"show", number(Show::ao)}}},
    {"--show normals", {{"show", number(Show::normals)}}},
    {"--show depth", {{"show", number(Show::depth)}}},
    {"--show level", {{"show", number(Show::level)}}},
    {"--shading gooch", {{"shading", number(Shading::gooch)}, {"backdrop", number(Backdrop::plain)}}},
    {"--shading gooch --backdrop sharp", {{"shading", number(Shading::gooch)}, {"backdrop", number(Backdrop::sharp)}}},
    {"--normals quaternion", {{"normals", number(NormalInterpolation::quaternion)}}},
    {"--transparency weighted", {{"transparency", number(Transparency::weighted)}}},
    {"--no-ao", {{"ao", 0.0}}},
    {"--ao ssao", {{"ao method", number(OcclusionMethod::ssao)}}},
    {"--ao rays", {{"ao method", number(OcclusionMethod::rays)}}},
    {"--environment-intensity 2.5", {{"environment intensity", 2.5}}},
    {"--environment-turn 90", {{"environment turn", number(1.57079632679f)}}},
    {"--exposure -2", {{"exposure", 0.25}}},
    {"--exposure auto", {{"auto exposure", 1.0}}},
    {"--tone neutral", {{"tone curve", number(ToneCurve::neutral)}}},
    {"--tone none", {{"tone curve", number(ToneCurve::none)}}},
    {"--no-shadows", {{"shadows", 0.0}}},
    {"--ground none", {{"ground", number(GroundLook::none)}}},
    {"--ground grid", {{"ground", number(GroundLook::grid)}}},
    {"--smoothing off", {{"smooth edges", 0.0}}},
    {"--smoothing on", {}},
    {"--backdrop plain", {{"backdrop", number(Backdrop::plain)}}},
    {"--backdrop sharp", {{"backdrop", number(Backdrop::sharp)}}},
    {"--skinning dual-quaternion", {{"skinning", number(Skinning::dual_quaternion)}}},
    {"--skinning center-of-rotation", {{"skinning", number(Skinning::center_of_rotation)}}},
    {"--updates every", {{"updates", number(Updates::every)}}},
    {"--updates held", {{"updates", number(Updates::held)}}},
    {"--headless a.png", {{"updates", number(Updates::every)}}},
    {"--headless a.png --plan --transparent", {{"updates", number(Updates::every)}}},
    {"--frame pose", {{"framing", number(Framing::pose)}}},
    {"--frame follow", {{"framing", number(Framing::follow)}}},
    {"--camera side", {{"camera", 1.0}}},
    {"--variant night", {{"variant", 1.0}}},
    {"a.glb --cache a.sgeo --cache-weight 0.25", {{"cache weight", 0.25}}},
    {"--skeleton", {{"skeleton", 1.0}}},
    {"--time 3 --clip none --size 64x32 --fov 20 --eye 1,2,3 --target 0,0,0 --filter nearest --environment none", {}},
};

TEST(option_effect, each_option_changes_its_own_field_alone) {
  for (const Effect& effect : kEffects) {
    Fields expected = without_any();
    for (const auto& [name, value] : effect.changed) {
      ASSERT_EQ(expected.count(name), 1u) << name;
      expected[name] = value;
    }
    for (const auto& [name, value] : fields_of(effect.words))
      EXPECT_FLOAT_EQ(static_cast<float>(value), static_cast<float>(expected[name])) << effect.words << ": " << name;
  }
}

TEST(option_effect, every_field_that_the_command_line_tells_is_changed_by_some_option) {
  for (const auto& [name, value] : without_any()) {
    const bool changed =
        std::ranges::any_of(kEffects, [&, of = name](const Effect& effect) { return effect.changed.contains(of); });
    EXPECT_EQ(changed, name != "panel" && name != "plan") << name;
  }
}

}  // namespace
}  // namespace sinew::viewer
