// SPDX-License-Identifier: MIT
// Meshes out of view are not deformed, and sleeping characters cost nothing. When they are seen again, their bits are
// those of a fresh frame.
#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/base/same_bits.h"
#include "runtime/plan/run_plan.h"
#include "runtime/playback/event_cursor.h"
#include "runtime/playback/root_motion.h"
#include "runtime/threads/job_thread.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/scenes/random_scene.h"
#include "tests/support/allocation_counter.h"

namespace sinew::test {
namespace {

bool same_shape(const DeformedPrimitive& a, const DeformedPrimitive& b) {
  return same_bits<glm::vec3>(a.positions, b.positions) && same_bits<glm::vec3>(a.normals, b.normals) &&
         same_bits<glm::vec4>(a.tangents, b.tangents) && same_bits<glm::vec4>(a.colors, b.colors);
}

bool is_nothing(const DeformedPrimitive& shape) {
  return shape.positions.empty() && shape.normals.empty() && shape.tangents.empty() && shape.colors.empty() &&
         shape.since_frame == 0;
}

/// The work counters of vertices and palettes; all others are set to 0.
WorkCounters mesh_work(WorkCounters work) {
  work.windings_tested = 0;  // the placement and the winding of a mesh are computed even out of view
  static_cast<PoseProgramWork&>(work) = {};
  work.poses_interpolated = work.poses_compared = work.joints_composed = 0;
  return work;
}

Needs all_needs() {
  Needs needs;
  needs.out.bounds = needs.out.palettes = true;
  return needs;
}

TEST(unseen_characters, P11_meshes_out_of_view_are_neither_morphed_nor_skinned_nor_bounded) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    RandomSceneOptions options;
    options.flat_normals = seed % 2;
    options.mirrored_joints = seed % 3 == 0;
    const Scene scene = random_scene(seed, options);
    Needs needs = all_needs();
    needs.out.hidden_meshes = seed % 4 == 0;  // independent of the view
    needs.skin.kind = seed % 5 == 0 ? Skinning::dual_quaternion : Skinning::linear;
    const Plan plan = compile_plan(lend(scene), needs);
    const ClipLayer layer{0, 0.6};
    FrameBuffer seen(plan), unseen(plan);
    const std::vector<std::uint8_t> all(scene.instances.size(), 1);
    ASSERT_EQ(run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, seen), ErrorCode::ok);
    ASSERT_EQ(run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}, .out_of_view = all}, unseen),
              ErrorCode::ok);
    ASSERT_NE(mesh_work(seen.result().work), WorkCounters{});
    EXPECT_EQ(mesh_work(unseen.result().work), WorkCounters{});
    EXPECT_EQ(unseen.result().work.joints_composed, scene.skeleton.joint_count());
    EXPECT_TRUE(same_bits<Affine>(seen.result().model, unseen.result().model)) << "a sword may hang on a joint";
    EXPECT_TRUE(same_bits<float>(seen.result().weights, unseen.result().weights));
    for (const SkinPalette& palette : unseen.result().palettes) EXPECT_TRUE(palette.matrices.empty());
    for (const InstanceResult& instance : unseen.result().instances) {
      EXPECT_FALSE(instance.visible);
      EXPECT_TRUE(instance.bounds.empty());
    }
    for (const DeformedPrimitive& shape : unseen.result().primitives) EXPECT_TRUE(is_nothing(shape));
  }
}

TEST(unseen_characters, a_mesh_out_of_view_changes_no_bit_of_the_others) {
  const Scene scene = random_scene(31);  // instances 0 and 2 are skinned, by skins 0 and 1
  const Plan plan = compile_plan(lend(scene), all_needs());
  const ClipLayer layer{1, 0.8};
  FrameBuffer seen(plan);
  ASSERT_EQ(run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, seen), ErrorCode::ok);
  for (std::uint32_t left_out = 0; left_out < scene.instances.size(); ++left_out) {
    std::vector<std::uint8_t> out_of_view(scene.instances.size(), 0);
    out_of_view[left_out] = 1;
    FrameBuffer some(plan);
    ASSERT_EQ(run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}, .out_of_view = out_of_view}, some),
              ErrorCode::ok);
    for (const PrimitivePlan& planned : plan.primitives()) {
      const std::size_t p = plan.first_primitive()[planned.instance] + planned.primitive;
      const DeformedPrimitive& shape = some.result().primitives[p];
      EXPECT_TRUE(planned.instance == left_out ? is_nothing(shape) : same_shape(shape, seen.result().primitives[p]));
    }
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
      EXPECT_EQ(some.result().instances[i].visible, i != left_out);
      EXPECT_EQ(some.result().instances[i].bounds.empty(), i == left_out);
    }
    const std::uint32_t skin = scene.instances[left_out].skin;
    std::uint64_t entries = 0;
    for (const Skin& other : scene.skins)
      entries += &other == &scene.skins[std::min<std::size_t>(skin, 1)] && skin != kNone ? 0 : other.joints.size();
    EXPECT_EQ(some.result().work.palette_entries, entries);
  }
}

TEST(unseen_characters, one_that_sleeps_does_exactly_nothing_and_gives_nothing) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    RandomSceneOptions options;
    options.skins = seed % 3;
    options.targets = seed % 2 * 3;
    options.flat_normals = seed % 2;
    options.correctives = seed % 2;
    const Scene scene = random_scene(seed, options);
    Needs needs = all_needs();
    needs.out.stage_times = true;
    const Plan plan = compile_plan(lend(scene), needs);
    FrameBuffer frame(plan);
    for (int number = 0; number < 6; ++number) {
      const ClipLayer layers[] = {{0, 0.1 * number, 0.5f}, {1, 0.2 * number, 0.5f}};
      FrameInput input{.layers = layers, .weights = {}, .root = {}};
      input.asleep = number >= 3;
      const AllocationCounter counter;
      ASSERT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
      EXPECT_EQ(counter.count(), 0u);
      const FrameResult& result = frame.result();
      EXPECT_EQ(result.work == WorkCounters{}, input.asleep);
      if (!input.asleep) continue;
      EXPECT_EQ(result.frame, static_cast<std::uint64_t>(number + 1));
      EXPECT_EQ(result.since_frame, 4u) << "nothing is the same nothing, whatever plays";
      EXPECT_TRUE(result.model.empty() && result.weights.empty() && result.properties.empty() && result.hidden.empty());
      for (const std::uint64_t ns : result.stage_ns) EXPECT_EQ(ns, 0u);
      for (const InstanceResult& instance : result.instances) EXPECT_TRUE(!instance.visible && instance.bounds.empty());
      for (const SkinPalette& palette : result.palettes) EXPECT_TRUE(palette.matrices.empty());
      for (const DeformedPrimitive& shape : result.primitives) EXPECT_TRUE(is_nothing(shape));
    }
  }
}

TEST(unseen_characters, P15_clocks_events_and_root_motion_go_on_while_one_sleeps) {
  const Scene scene = arm_scene();
  const Plan plan = compile_plan(lend(scene), {});
  const std::vector<double> events_s{0.25, 0.75};
  BoneAnimation walk;
  walk.translation = {.interpolation = Interpolation::linear,
                      .times_s = {0.0f, 1.0f},
                      .values = {glm::vec3(0.0f), glm::vec3(2.0f, 0.0f, 0.0f)}};
  struct Character {
    PlaybackClock clock{1.0};
    FrameBuffer frame;
    DualQuatd place{};
    std::vector<std::size_t> fired;
  };
  Character awake{.frame = FrameBuffer(plan)}, sleeper{.frame = FrameBuffer(plan)};
  for (int number = 0; number < 200; ++number) {
    for (Character* character : {&awake, &sleeper}) {
      const PlaybackStep step = character->clock.advance(1.0 / 30.0);
      for (EventCursor crossed(step, events_s); const auto event = crossed.next();) character->fired.push_back(*event);
      character->place = normalised(character->place * root_motion(walk, Transform{}, {}, step));
      const ClipLayer layer{0, character->clock.time_s()};
      FrameInput input{.layers = {&layer, 1}, .weights = {}, .root = {}};
      input.asleep = character == &sleeper && number % 50 > 4;
      ASSERT_EQ(run_plan(plan, input, character->frame), ErrorCode::ok);
      EXPECT_EQ(character->frame.result().work == WorkCounters{}, input.asleep);
      if (character == &awake || input.asleep) continue;
      EXPECT_TRUE(same_bits<Affine>(awake.frame.result().model, sleeper.frame.result().model));
      EXPECT_TRUE(same_shape(awake.frame.result().primitives[0], sleeper.frame.result().primitives[0])) << number;
    }
  }
  EXPECT_EQ(awake.fired, sleeper.fired);
  EXPECT_EQ(awake.fired.size(), 13u);
  EXPECT_TRUE(same_bits(awake.place, sleeper.place));
  EXPECT_NEAR(translation_of(sleeper.place).x, 2.0 * 200.0 / 30.0, 1e-9) << "2 m a round, 200 frames of 1/30 s";
  EXPECT_NEAR(sleeper.clock.time_s(), 200.0 / 30.0 - 6.0, 1e-9);
}

TEST(unseen_characters, a_pose_from_before_the_sleep_is_not_taken_for_the_resting_one) {
  const Scene scene = arm_scene();
  const Plan plan = compile_plan(lend(scene), {});
  FrameBuffer frame(plan), fresh(plan);
  const ClipLayer bent{0, 1.0};
  ASSERT_EQ(run_plan(plan, {.layers = {&bent, 1}, .weights = {}, .root = {}}, frame), ErrorCode::ok);
  FrameInput rest;
  rest.asleep = true;
  ASSERT_EQ(run_plan(plan, rest, frame), ErrorCode::ok);
  rest.asleep = false;
  for (FrameBuffer* buffer : {&frame, &fresh}) ASSERT_EQ(run_plan(plan, rest, *buffer), ErrorCode::ok);
  EXPECT_TRUE(same_bits<Affine>(frame.result().model, fresh.result().model));
  EXPECT_TRUE(same_shape(frame.result().primitives[0], fresh.result().primitives[0]));
}

TEST(unseen_characters, a_paused_character_is_shown_again_when_it_comes_back_into_view) {
  const Scene scene = arm_scene();
  const Plan plan = compile_plan(lend(scene), all_needs());
  const ClipLayer paused{0, 0.7};
  const std::uint8_t away[] = {1};
  FrameInput seen{.layers = {&paused, 1}, .weights = {}, .root = {}}, unseen = seen;
  unseen.out_of_view = away;
  FrameBuffer fresh(plan);
  ASSERT_EQ(run_plan(plan, seen, fresh), ErrorCode::ok);
  ASSERT_EQ(fresh.result().primitives[0].positions.size(), 4u);
  for (const std::size_t buffer_count : {1u, 2u, 3u}) {
    std::vector<FrameBuffer> buffers;
    for (std::size_t b = 0; b < buffer_count; ++b) buffers.emplace_back(plan);
    std::uint64_t number = 0, back_since = 0;
    for (const FrameInput& input : {seen, seen, unseen, unseen, unseen, seen, seen, seen, unseen, seen}) {
      FrameBuffer& frame = buffers[number % buffer_count];
      frame.count_from(number);
      if (number > 0) frame.follow(buffers[(number - 1) % buffer_count]);
      ASSERT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
      ++number;
      const DeformedPrimitive& shape = frame.result().primitives[0];
      const bool is_seen = input.out_of_view.empty();
      EXPECT_EQ(frame.result().instances[0].visible, is_seen) << number;
      EXPECT_TRUE(is_seen ? same_shape(shape, fresh.result().primitives[0]) : is_nothing(shape)) << number;
      EXPECT_EQ(same_bits(frame.result().instances[0].bounds, fresh.result().instances[0].bounds), is_seen) << number;
      if (number == 6) back_since = shape.since_frame;
      EXPECT_TRUE(number < 7 || number > 8 || shape.since_frame == back_since) << "uploaded once";
    }
    EXPECT_EQ(back_since, 6u);
  }
}

TEST(unseen_characters, the_job_thread_passes_on_who_is_seen) {
  const Scene scene = arm_scene();
  const Plan plan = compile_plan(lend(scene), {});
  JobThread jobs;
  for (int c = 0; c < 3; ++c) jobs.add_character(plan);
  const ClipLayer layer{0, 0.5};
  const std::uint8_t unseen = 1;
  FrameInput inputs[3];
  for (FrameInput& input : inputs) input.layers = {&layer, 1};
  inputs[1].out_of_view = {&unseen, 1};
  inputs[2].asleep = true;
  jobs.wait(*jobs.submit(inputs));
  EXPECT_EQ(jobs.latest(0)->work.vertices_skinned_linear, 4u);
  EXPECT_EQ(jobs.latest(1)->work.vertices_skinned_linear, 0u);
  EXPECT_EQ(jobs.latest(1)->work.joints_composed, 3u);
  EXPECT_EQ(jobs.latest(2)->work, WorkCounters{});
}

TEST(unseen_characters, as_many_instances_as_the_scene_has_are_in_or_out_of_view) {
  const Scene scene = arm_scene();
  const Plan plan = compile_plan(lend(scene), {});
  FrameBuffer frame(plan);
  const std::vector<std::uint8_t> too_many(2, 0);
  EXPECT_EQ(run_plan(plan, {.layers = {}, .weights = {}, .root = {}, .out_of_view = too_many}, frame),
            ErrorCode::size_mismatch);
}

}  // namespace
}  // namespace sinew::test
