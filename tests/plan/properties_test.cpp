// SPDX-License-Identifier: MIT
#include "runtime/model/scene_look.h"

#include <gtest/gtest.h>

#include "runtime/animation/track_sample.h"
#include "runtime/plan/run_plan.h"
#include "tests/plan/plan_dump.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

constexpr PropertyKind kVisible = PropertyKind::node_visible;

WeightTrack numbers(Interpolation interpolation, std::vector<float> times_s, std::vector<float> values,
                    std::uint32_t count = 1) {
  return {interpolation, std::move(times_s), std::move(values), count};
}

/// A triangle; a clip animates its material, a light and a camera.
Scene lit_scene() {
  Scene scene = prop_scene();
  Material material;
  material.base_color = {0.5f, 0.25f, 0.125f, 1.0f};
  material.normal_texture.scale = {3.0f, 4.0f};
  scene.materials = {material, material};
  scene.meshes[0].primitives[0].material = 1;
  scene.cameras.resize(1);
  scene.lights.resize(1);
  scene.lights[0].joint = 0;
  Animation glow{"glow", 2.0, {}, {}};
  glow.properties = {
      {{PropertyKind::base_color, 1}, numbers(Interpolation::linear, {0, 2}, {0, 0, 0, 1, 1, 1, 0.5f, 0}, 4)},
      {{PropertyKind::texture_offset, 1, TextureSlot::normal}, numbers(Interpolation::step, {0, 1}, {0, 0, 5, 6}, 2)},
      {{PropertyKind::light_intensity, 0}, numbers(Interpolation::cubic_spline, {0, 2}, {0, 1, 0, 0, 3, 0})},
      {{PropertyKind::camera_fov_y, 0}, numbers(Interpolation::linear, {0, 2}, {1, 2})},
      {{PropertyKind::roughness, 1}, numbers(Interpolation::linear, {0, 2}, {0.25f, 0.25f})}};
  scene.animations.push_back(glow);
  finish_scene(scene);
  EXPECT_EQ(check(scene), ErrorCode::ok);
  return scene;
}

/// The arm of hand_scenes.h; a clip makes its holder visible from `on_s` on.
Scene blinking_arm(float on_s) {
  Scene scene = arm_scene();
  scene.animations[0].properties = {{{kVisible, 1}, numbers(Interpolation::step, {0, on_s}, {0, 1})}};
  finish_scene(scene);
  EXPECT_EQ(check(scene), ErrorCode::ok);
  return scene;
}

SceneLook look_at_time(const Scene& scene, std::span<const ClipLayer> layers) {
  const Plan plan = compile_plan(lend(scene), {});
  FrameBuffer frame(plan);
  EXPECT_EQ(run_plan(plan, {.layers = layers, .weights = {}, .root = {}}, frame), ErrorCode::ok);
  SceneLook look(scene);
  apply_properties(scene, frame.result().properties, look);
  return look;
}

TEST(properties, G58_every_animated_property_arrives_where_it_belongs) {
  const Scene scene = lit_scene();
  const ClipLayer layer{0, 1.0, 1.0f};
  const SceneLook look = look_at_time(scene, {&layer, 1});
  EXPECT_EQ(look.materials[1].base_color, glm::vec4(0.5f, 0.5f, 0.25f, 0.5f));
  EXPECT_EQ(look.materials[1].normal_texture.offset, glm::vec2(5, 6));
  EXPECT_EQ(look.materials[1].normal_texture.scale, glm::vec2(3, 4));
  EXPECT_EQ(look.materials[1].roughness, 0.25f);
  EXPECT_EQ(look.materials[0].base_color, scene.materials[0].base_color);
  EXPECT_EQ(look.materials[0].normal_texture.offset, glm::vec2(0));
  EXPECT_EQ(look.lights[0].intensity, 2.0f);
  EXPECT_EQ(look.cameras[0].fov_y_rad, 1.5f);
}

TEST(properties, G22_without_a_clip_they_rest) {
  const Scene scene = lit_scene();
  const SceneLook look = look_at_time(scene, {});
  EXPECT_EQ(look.materials[1].base_color, scene.materials[1].base_color);
  EXPECT_EQ(look.lights[0].intensity, 1.0f);
}

TEST(properties, layers_are_averaged_and_filled_up_with_the_rest) {
  const Scene scene = lit_scene();
  const ClipLayer layers[] = {{0, 0.0, 0.25f}, {0, 2.0, 0.25f}};
  const SceneLook look = look_at_time(scene, layers);
  EXPECT_FLOAT_EQ(look.lights[0].intensity, 0.25f * 1.0f + 0.25f * 3.0f + 0.5f * 1.0f);
  EXPECT_FLOAT_EQ(look.materials[1].base_color.r, 0.25f * 0.0f + 0.25f * 1.0f + 0.5f * 0.5f);
}

TEST(properties, sampled_ones_agree_with_the_tracks_in_double) {
  FixedRandom random(5);
  Scene scene = lit_scene();
  scene.animations[0].properties.clear();
  const PropertyKind kinds[] = {PropertyKind::base_color, PropertyKind::emissive, PropertyKind::alpha_cutoff};
  for (const Interpolation interpolation : {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline})
    for (const PropertyKind kind : kinds) {
      const std::uint32_t material = interpolation == Interpolation::step     ? 0
                                     : interpolation == Interpolation::linear ? 1
                                                                              : 2;
      const std::size_t per_key = component_count(kind) * (interpolation == Interpolation::cubic_spline ? 3 : 1);
      std::vector<float> times = {0.0f, 0.3f, 0.35f, 2.0f}, values(times.size() * per_key);
      for (float& v : values) v = static_cast<float>(random.in(-2.0, 2.0));
      scene.animations[0].properties.push_back(
          {{kind, material}, numbers(interpolation, times, values, component_count(kind))});
    }
  scene.materials.resize(3);
  finish_scene(scene);
  ASSERT_EQ(check(scene), ErrorCode::ok);
  const Plan plan = compile_plan(lend(scene), {.in = {.max_layers = 1}});
  FrameBuffer frame(plan);
  for (double time_s = -0.1; time_s < 2.2; time_s += 0.0137) {
    const ClipLayer layer{0, time_s, 1.0f};
    ASSERT_EQ(run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, frame), ErrorCode::ok);
    for (const PropertyTrack& track : scene.animations[0].properties) {
      std::vector<double> truth(track.values.target_count);
      sample_track(track.values, time_s, std::span<double>(truth));
      const PropertyTable::Entry* entry = scene.properties.find(track.target);
      ASSERT_NE(entry, nullptr);
      for (std::size_t c = 0; c < truth.size(); ++c)
        EXPECT_NEAR(static_cast<double>(frame.result().properties[entry->first + c]), truth[c], 2e-6) << time_s;
    }
  }
}

TEST(properties, P15_the_stage_runs_only_for_scenes_and_needs_that_call_for_it) {
  EXPECT_FALSE(stage(compile_plan(arm_scene(), {}), "properties").runs);
  const Scene scene = lit_scene();
  const Plan asked = compile_plan(lend(scene), {}), unasked = compile_plan(lend(scene), {.out = {.properties = false}});
  EXPECT_TRUE(stage(asked, "properties").runs);
  EXPECT_EQ(stage(asked, "properties").count, 9u);
  EXPECT_FALSE(stage(unasked, "properties").runs);
  const ClipLayer layer{0, 1.0, 1.0f};
  FrameBuffer with(asked), without(unasked);
  ASSERT_EQ(run_plan(asked, {.layers = {&layer, 1}, .weights = {}, .root = {}}, with), ErrorCode::ok);
  ASSERT_EQ(run_plan(unasked, {.layers = {&layer, 1}, .weights = {}, .root = {}}, without), ErrorCode::ok);
  EXPECT_EQ(with.result().work.properties_sampled, 8u) << "the constant roughness is folded";
  EXPECT_EQ(without.result().work.properties_sampled, 0u);
  EXPECT_TRUE(without.result().properties.empty());
}

TEST(properties, hidden_instances_cost_nothing_and_come_back) {
  const Scene scene = blinking_arm(0.5f);
  const Plan plan = compile_plan(lend(scene), {.out = {.bounds = true}});
  EXPECT_TRUE(stage(plan, "properties").runs);
  FrameBuffer frame(plan);
  const auto at = [&](double time_s) -> const FrameResult& {
    const ClipLayer layer{0, time_s, 1.0f};
    EXPECT_EQ(run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, frame), ErrorCode::ok);
    return frame.result();
  };
  at(0.75);
  EXPECT_TRUE(frame.result().instances[0].visible);
  EXPECT_EQ(frame.result().work.vertices_skinned_linear, 4u);
  at(0.25);
  EXPECT_FALSE(frame.result().instances[0].visible);
  EXPECT_TRUE(frame.result().hidden[1]);
  EXPECT_FALSE(frame.result().hidden[0]);
  EXPECT_TRUE(frame.result().instances[0].bounds.empty());
  EXPECT_TRUE(frame.result().primitives[0].positions.empty());
  EXPECT_EQ(frame.result().work.vertices_skinned_linear, 0u);
  EXPECT_EQ(frame.result().work.palette_entries, 0u);
  EXPECT_EQ(frame.result().work.bounds_vertices, 0u);
  EXPECT_TRUE(at(0.5).instances[0].visible) << "from the key on";
}

TEST(properties, flags_hide_whatever_is_asked_for) {
  const Scene scene = blinking_arm(0.5f);
  Needs none;
  none.out.joints = none.out.positions = none.out.normals = none.out.tangents = none.out.weights = none.out.properties =
      false;
  const auto with = [&](bool Outputs::*need) {
    Needs needs = none;
    needs.out.*need = true;
    return needs;
  };
  for (const Needs& needs : {with(&Outputs::palettes), with(&Outputs::positions), with(&Outputs::normals),
                             with(&Outputs::bounds), with(&Outputs::properties)}) {
    const Plan plan = compile_plan(lend(scene), needs);
    FrameBuffer frame(plan);
    for (const double time_s : {0.25, 0.75}) {
      const ClipLayer layer{0, time_s, 1.0f};
      ASSERT_EQ(run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, frame), ErrorCode::ok);
      EXPECT_EQ(frame.result().instances[0].visible, time_s > 0.5);
      EXPECT_EQ(frame.result().work.palette_entries > 0, time_s > 0.5 && !needs.out.properties);
    }
  }
}

TEST(properties, a_flag_hides_what_is_below_its_node) {
  Scene scene = arm_scene();
  scene.instances[0].joint = 2;  // below joint 0
  scene.instances[0].skin = kNone;
  scene.hidden_joints = {0};
  finish_scene(scene);
  const Plan plan = compile_plan(lend(scene), {});
  FrameBuffer frame(plan);
  ASSERT_EQ(run_plan(plan, {}, frame), ErrorCode::ok);
  EXPECT_FALSE(frame.result().instances[0].visible);
  EXPECT_TRUE(frame.result().hidden[2]);
  EXPECT_FALSE(frame.result().hidden[1]);
}

TEST(properties, meshes_that_no_clip_ever_shows_are_left_out_of_the_plan) {
  Scene scene = arm_scene();
  scene.hidden_joints = {1};
  finish_scene(scene);
  ASSERT_EQ(check(scene), ErrorCode::ok);
  const Plan plan = compile_plan(lend(scene), {}), all = compile_plan(lend(scene), {.out = {.hidden_meshes = true}});
  EXPECT_FALSE(stage(plan, "skin_linear").runs);
  EXPECT_FALSE(stage(plan, "palette").runs);
  EXPECT_TRUE(stage(all, "skin_linear").runs);
  FrameBuffer frame(all);
  ASSERT_EQ(run_plan(all, {}, frame), ErrorCode::ok);
  EXPECT_FALSE(frame.result().instances[0].visible);
  EXPECT_EQ(frame.result().primitives[0].positions.size(), 4u);
}

TEST(properties, a_frame_allocates_nothing) {
  const Scene scene = blinking_arm(0.5f);
  const Plan plan = compile_plan(lend(scene), {});
  FrameBuffer frame(plan);
  const ClipLayer layers[] = {{0, 0.25, 0.5f}, {0, 0.75, 0.5f}};
  ASSERT_EQ(run_plan(plan, {.layers = layers, .weights = {}, .root = {}}, frame), ErrorCode::ok);
  const AllocationCounter counter;
  ASSERT_EQ(run_plan(plan, {.layers = layers, .weights = {}, .root = {}}, frame), ErrorCode::ok);
  EXPECT_EQ(counter.count(), 0u);
  EXPECT_TRUE(frame.result().instances[0].visible) << "one half is on";
}

TEST(properties, boxes_hold_all_copies_of_a_mesh) {
  Scene scene = prop_scene();
  scene.instances[0].copies = {{{10, 0, 0}, glm::quat(1, 0, 0, 0), {1, 1, 1}},
                               {{0, 0, 5}, glm::quat(0, 0, 0, 1), {2, 2, 2}}};
  finish_scene(scene);
  ASSERT_EQ(check(scene), ErrorCode::ok);
  const Plan plan = compile_plan(lend(scene), {.out = {.bounds = true}});
  FrameBuffer frame(plan);
  ASSERT_EQ(run_plan(plan, {}, frame), ErrorCode::ok);
  EXPECT_EQ(frame.result().instances[0].bounds.lower, glm::vec3(-2, -2, 0));
  EXPECT_EQ(frame.result().instances[0].bounds.upper, glm::vec3(11, 1, 5));
}

TEST(properties, asset_checks_reject_what_the_jobs_cannot_run) {
  const auto with = [](PropertyTrack track) {
    Scene scene = lit_scene();
    const PropertyTarget target = track.target;
    scene.animations[0].properties[0].values = std::move(track.values);
    scene.animations[0].properties[0].target = target;
    return check(scene);
  };
  EXPECT_EQ(
      with({{PropertyKind::base_color, 1}, numbers(Interpolation::linear, {0, 2}, {0, 0, 0, 1, 1, 1, 0.5f, 0}, 4)}),
      ErrorCode::ok);
  EXPECT_EQ(with({{PropertyKind::base_color, 2}, numbers(Interpolation::linear, {0}, {0, 0, 0, 1}, 4)}),
            ErrorCode::index_out_of_range);
  EXPECT_EQ(with({{PropertyKind::base_color, 1}, numbers(Interpolation::linear, {0}, {0, 0, 0}, 3)}),
            ErrorCode::size_mismatch);
  EXPECT_EQ(with({{PropertyKind::base_color, 1}, numbers(Interpolation::linear, {1, 0}, {0, 0, 0, 1, 1, 1, 1, 1}, 4)}),
            ErrorCode::times_not_increasing);
  EXPECT_EQ(with({{PropertyKind::metallic, 1}, numbers(Interpolation::linear, {0}, {0})}),
            ErrorCode::index_out_of_range)
      << "not in the table";
  Scene flag = blinking_arm(0.5f);
  flag.animations[0].properties[0].values.interpolation = Interpolation::linear;
  EXPECT_EQ(check(flag), ErrorCode::unsupported);
  flag = blinking_arm(0.5f);
  flag.hidden_joints = {3};
  EXPECT_EQ(check(flag), ErrorCode::index_out_of_range);
}

}  // namespace
}  // namespace sinew::test
