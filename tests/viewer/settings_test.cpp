// SPDX-License-Identifier: MIT
#include "viewer/app/settings.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sinew::viewer {
namespace {

TEST(settings, begin_as_the_command_line_says) {
  Scene scene;
  scene.instances.emplace_back();
  Options options;
  options.show = Show::depth;
  options.normals = NormalInterpolation::quaternion;
  options.transparency = Transparency::weighted;
  options.ambient_occlusion = false;
  options.skinning = Skinning::dual_quaternion;
  options.cache_weight = 0.25f;
  options.environment_turn_deg = 90.0f;
  options.environment_intensity = 0.5f;
  options.exposure_ev = -2.0f;
  options.auto_exposure = true;
  options.backdrop = Backdrop::blurred;
  options.tone_curve = ToneCurve::none;
  options.ground = GroundLook::grid;
  options.occlusion_method = OcclusionMethod::ssao;
  const Settings settings = settings_from(options, scene);
  EXPECT_EQ(settings.show, Show::depth);
  EXPECT_EQ(settings.normals, NormalInterpolation::quaternion);
  EXPECT_EQ(settings.transparency, Transparency::weighted);
  EXPECT_EQ(render_options(settings, nullptr, {}, {0, 0, 5}).transparency, Transparency::weighted);
  EXPECT_FALSE(settings.ambient_occlusion);
  EXPECT_EQ(settings.skinning, Skinning::dual_quaternion);
  EXPECT_EQ(settings.cache_weight, 0.25f);
  const auto environment = gradient_environment({});
  const Lighting light = render_options(settings, environment, {}, {0, 0, 5}).lighting;
  EXPECT_EQ(light.environment, environment);
  EXPECT_EQ(light.environment_intensity, 0.5f);
  EXPECT_FLOAT_EQ(light.environment_turn_rad, 1.57079633f);
  EXPECT_EQ(light.exposure, 0.25f);
  EXPECT_TRUE(light.auto_exposure);
  EXPECT_EQ(light.tone_curve, ToneCurve::none);
  EXPECT_TRUE(render_options(settings, environment, {}, {0, 0, 5}).smooth_edges);
  EXPECT_TRUE(render_options(settings, environment, {}, {0, 0, 5}).shadows.on);
  EXPECT_EQ(render_options(settings, environment, {}, {0, 0, 5}).ground.look, GroundLook::grid);
  EXPECT_EQ(render_options(settings, environment, {}, {0, 0, 5}).ao.method, OcclusionMethod::ssao);
  EXPECT_EQ(render_options(settings, environment, {}, {0, 0, 5}).backdrop, Backdrop::blurred);
  EXPECT_TRUE(settings.panel);
  EXPECT_FALSE(settings.skeleton);
  options.skeleton = true;
  EXPECT_TRUE(settings_from(options, scene).skeleton);
}

TEST(settings, begin_with_the_camera_and_the_variant_that_the_command_line_names) {
  Scene scene;
  scene.cameras = {{.name = "front", .joint = 0}, {.name = "side", .joint = 0}};
  scene.variants = {"day", "night"};
  Options options;
  EXPECT_EQ(settings_from(options, scene).camera, kNone);
  EXPECT_EQ(settings_from(options, scene).variant, kNone);
  options.file_camera = "side";
  options.variant = "night";
  options.framing = Framing::follow;
  EXPECT_EQ(settings_from(options, scene).framing, Framing::follow);
  EXPECT_EQ(settings_from(options, scene).camera, 1u);
  EXPECT_EQ(settings_from(options, scene).variant, 1u);
}

TEST(settings, ground_changes_in_turn) {
  Settings settings;
  for (const GroundLook next : {GroundLook::grid, GroundLook::none, GroundLook::shadows}) {
    next_ground(settings);
    EXPECT_EQ(settings.ground, next);
  }
}

TEST(settings, pictures_are_evaluated_in_every_frame_unless_asked_otherwise) {
  Options window, pictures;
  pictures.headless = "folder/";
  EXPECT_EQ(settings_from(window, Scene{}).updates, Updates::interpolated);
  EXPECT_EQ(settings_from(pictures, Scene{}).updates, Updates::every);
  for (Options* options : {&window, &pictures}) {
    options->updates = Updates::held;
    EXPECT_EQ(settings_from(*options, Scene{}).updates, Updates::held);
  }
  Settings settings;
  const Evaluation first = settings.evaluation();
  next_updates(settings);
  EXPECT_EQ(settings.updates, Updates::held);
  EXPECT_NE(settings.evaluation(), first) << "another plan";
  next_updates(settings);
  next_updates(settings);
  EXPECT_EQ(settings.evaluation(), first);
}

TEST(settings, a_scene_without_meshes_shows_its_skeleton) { EXPECT_TRUE(settings_from({}, Scene{}).skeleton); }

TEST(settings, the_live_plan_comes_with_the_panel) {
  Settings settings;
  settings.panel = false;
  toggle_plan(settings);
  EXPECT_TRUE(settings.panel && settings.plan && settings.shows_plan());
  settings.panel = false;
  EXPECT_FALSE(settings.shows_plan()) << "what nobody sees is not measured";
  toggle_plan(settings);
  EXPECT_TRUE(settings.shows_plan());
  toggle_plan(settings);
  EXPECT_TRUE(settings.panel && !settings.plan);
}

TEST(settings, ao_only_turns_ao_on_and_goes_back_to_the_lit_picture) {
  Settings settings;
  settings.ambient_occlusion = false;
  toggle_ao_only(settings);
  EXPECT_EQ(settings.show, Show::ao);
  EXPECT_TRUE(settings.ambient_occlusion);
  toggle_ao_only(settings);
  EXPECT_EQ(settings.show, Show::color);
}

TEST(settings, show_and_skinning_go_around) {
  Settings settings;
  for (const Show expected : {Show::ao, Show::normals, Show::depth, Show::level, Show::color}) {
    next_show(settings);
    EXPECT_EQ(settings.show, expected);
  }
  for (const Skinning expected : {Skinning::dual_quaternion, Skinning::center_of_rotation, Skinning::linear}) {
    next_skinning(settings);
    EXPECT_EQ(settings.skinning, expected);
  }
}

TEST(settings, shading_lengths_follow_the_largest_pose_not_the_way_it_walks) {
  ClipExtent standing, walking;
  standing.reached.add({-1, 0, -1});
  standing.reached.add({1, 2, 1});
  standing.largest = walking.largest = standing.reached;
  walking.reached = standing.reached;
  walking.reached.add({500, 2, 1});
  Settings settings;
  settings.ambient_occlusion = false;
  settings.show = Show::normals;
  settings.normals = NormalInterpolation::quaternion;
  const auto a = render_options(settings, nullptr, standing, {0, 1, 8}),
             b = render_options(settings, nullptr, walking, {0, 1, 8});
  EXPECT_EQ(a.ao.radius_m, b.ao.radius_m);
  EXPECT_GT(a.ao.radius_m, 0.0f);
  EXPECT_GT(b.depth_range.farthest_m, a.depth_range.farthest_m);
  const DepthRange inside = render_options(settings, nullptr, standing, {0, 1, 0}).depth_range;
  EXPECT_EQ(inside.nearest_m, 0.0f) << "the eye is among what it sees";
  EXPECT_FLOAT_EQ(inside.farthest_m, std::sqrt(3.0f));
  EXPECT_FALSE(a.ao.on);
  EXPECT_EQ(a.show, Show::normals);
  EXPECT_EQ(a.normals, NormalInterpolation::quaternion);
}

}  // namespace
}  // namespace sinew::viewer
