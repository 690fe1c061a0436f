// SPDX-License-Identifier: MIT
// The C interface gives the bits of the C++ one, uses the memory and threads it is given, and refuses impossible
// requests. C code in engine.c reads the results.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <iterator>

#include "runtime/base/same_bits.h"
#include "runtime/c/handles.h"
#include "runtime/plan/run_plan.h"
#include "runtime/playback/event_cursor.h"
#include "tests/c/engine.h"
#include "tests/c/numbers.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/scenes/random_scene.h"
#include "tests/support/allocation_counter.h"

namespace sinew::test {
namespace {

/// The numbers that engine_read reads, taken from the C++ result.
std::vector<float> numbers_of(const FrameResult& frame) {
  std::vector<float> all;
  add_numbers(all, frame.model);
  add_numbers(all, frame.weights);
  add_numbers(all, frame.properties);
  for (const bool hidden : frame.hidden) all.push_back(hidden);
  for (const SkinPalette& palette : frame.palettes) add_numbers(all, palette.matrices);
  for (const InstanceResult& i : frame.instances) {
    add_numbers(all, std::span(&i.world_from_mesh, 1));
    add_numbers(all, std::span(&i.bounds, 1));
    all.insert(all.end(), {static_cast<float>(i.first_primitive), i.mirrored ? 1.0f : 0.0f, i.visible ? 1.0f : 0.0f});
  }
  for (const DeformedPrimitive& p : frame.primitives) {
    all.insert(all.end(), {static_cast<float>(p.instance), static_cast<float>(p.primitive)});
    add_numbers(all, p.positions);
    add_numbers(all, p.normals);
    add_numbers(all, p.tangents);
    add_numbers(all, p.colors);
  }
  return all;
}

std::vector<float> numbers_of(const Scene& scene, const Needs& needs, const FrameInput& input) {
  const Plan plan = compile_plan(lend(scene), needs);
  FrameBuffer frame(plan);
  EXPECT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
  return numbers_of(frame.result());
}

void expect_same(const std::vector<float>& a, const std::vector<float>& b) { EXPECT_TRUE(same_bits<float>(a, b)); }

sinew_needs all_needs() {
  sinew_needs needs = sinew_default_needs();
  needs.flags |= SINEW_NEED_BOUNDS | SINEW_NEED_ADDITIVE | SINEW_NEED_PALETTES;
  return needs;
}

Needs all_needs_in_cpp() {
  Needs needs;
  needs.out.bounds = needs.in.additive = needs.out.palettes = true;
  return needs;
}

sinew_scene random_handle(std::uint64_t seed) {
  RandomSceneOptions options;
  options.correctives = seed % 2;
  options.mirrored_joints = seed % 3 == 0;
  options.centers = true;
  return {random_scene(seed, options)};
}

constexpr sinew_layer kLayers[] = {{0.4, 0, SINEW_NONE, 0.7f, SINEW_LAYER_BLEND},
                                   {0.9, 1, SINEW_NONE, 0.3f, SINEW_LAYER_BLEND},
                                   {1.1, 1, SINEW_NONE, 0.5f, SINEW_LAYER_ADD_TO_START}};
constexpr ClipLayer kLayersInCpp[] = {{0, 0.4, 0.7f}, {1, 0.9, 0.3f}, {1, 1.1, 0.5f, kNone, LayerKind::add_to_start}};

sinew_frame_input layered_input() {
  sinew_frame_input input = sinew_default_input();
  input.layers = kLayers;
  input.layer_count = std::size(kLayers);
  input.root.row[0][3] = 2.0f;
  return input;
}

FrameInput layered_input_in_cpp() {
  FrameInput input{.layers = kLayersInCpp, .weights = {}, .root = {}};
  input.root.row[0].w = 2.0f;
  return input;
}

TEST(c_interface, frames_have_the_bits_of_the_cpp_interface) {
  const sinew_frame_input input = layered_input();
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const sinew_scene scene = random_handle(seed);
    sinew_needs needs = all_needs();
    Needs needs_in_cpp = all_needs_in_cpp();
    needs.skinning = static_cast<std::uint32_t>(seed % 3);
    needs_in_cpp.skin.kind = static_cast<Skinning>(seed % 3);
    Numbers read, in_block;
    ASSERT_EQ(engine_play(&scene, &needs, &input, nullptr, &read), SINEW_OK);
    ASSERT_EQ(engine_play_in_block(&scene, &needs, &input, &in_block), SINEW_OK);
    const std::vector<float> expected = numbers_of(scene.scene, needs_in_cpp, layered_input_in_cpp());
    EXPECT_GT(expected.size(), 1000u);
    expect_same(read.all(), expected);
    expect_same(in_block.all(), expected);
  }
}

TEST(c_interface, what_nobody_sees_is_told_to_the_frame) {
  const sinew_scene scene = random_handle(6);
  const sinew_needs needs = all_needs();
  const std::vector<std::uint8_t> out_of_view{0, 1, 1, 0};
  ASSERT_EQ(scene.scene.instances.size(), out_of_view.size());
  sinew_frame_input input = layered_input();
  FrameInput in_cpp = layered_input_in_cpp();
  input.out_of_view = out_of_view.data();
  in_cpp.out_of_view = out_of_view;
  Numbers some, none;
  ASSERT_EQ(engine_play(&scene, &needs, &input, nullptr, &some), SINEW_OK);
  expect_same(some.all(), numbers_of(scene.scene, all_needs_in_cpp(), in_cpp));
  input.asleep = 2;  // any nonzero number is true
  in_cpp.asleep = true;
  ASSERT_EQ(engine_play(&scene, &needs, &input, nullptr, &none), SINEW_OK);
  expect_same(none.all(), numbers_of(scene.scene, all_needs_in_cpp(), in_cpp));
  EXPECT_LT(none.count, some.count);
}

TEST(c_interface, masks_weights_and_skinning_per_instance_reach_the_plan) {
  const sinew_scene scene = random_handle(4);
  const std::size_t joints = scene.scene.skeleton.joint_count();
  std::vector<float> masks(2 * joints, 1.0f);
  for (std::size_t j = 0; j < joints; ++j) masks[joints + j] = 0.125f * static_cast<float>(j % 8);
  const unsigned char skinning[] = {1, 0, 2, 0};
  ASSERT_EQ(scene.scene.instances.size(), std::size(skinning));
  sinew_needs needs = sinew_default_needs();
  needs.masks = masks.data();
  needs.mask_count = 2;
  needs.instance_skinning = skinning;
  Needs in_cpp;
  in_cpp.in.masks = {{masks.begin(), masks.begin() + static_cast<std::ptrdiff_t>(joints)},
                     {masks.begin() + static_cast<std::ptrdiff_t>(joints), masks.end()}};
  in_cpp.skin.per_instance = {Skinning::dual_quaternion, Skinning::linear, Skinning::center_of_rotation,
                              Skinning::linear};
  const std::vector<float> weights(scene.scene.weight_count(), 0.25f);

  const sinew_layer layers[] = {{0.4, 0, SINEW_NONE, 1.0f, 0}, {0.8, 1, 1, 2.0f, 0}};
  sinew_frame_input input = sinew_default_input();
  input.layers = layers;
  input.layer_count = 2;
  input.weights = {weights.data(), weights.size()};
  Numbers read;
  ASSERT_EQ(engine_play(&scene, &needs, &input, nullptr, &read), SINEW_OK);
  const ClipLayer layers_in_cpp[] = {{0, 0.4}, {1, 0.8, 2.0f, 1}};
  expect_same(read.all(), numbers_of(scene.scene, in_cpp, {.layers = layers_in_cpp, .weights = weights, .root = {}}));
}

TEST(c_interface, scenes_are_found_through_by_name_and_index) {
  sinew_scene scene{arm_scene()};
  ASSERT_EQ(sinew_joint_count(&scene), scene.scene.skeleton.joint_count());
  const std::uint32_t lower = sinew_find_joint(&scene, "lower");
  ASSERT_NE(lower, SINEW_NONE);
  EXPECT_EQ(sinew_joint_parent(&scene, lower), sinew_find_joint(&scene, "upper"));
  EXPECT_EQ(sinew_joint_parent(&scene, sinew_find_joint(&scene, "upper")), SINEW_NONE);
  EXPECT_EQ(std::string_view(sinew_joint_name(&scene, lower).data, sinew_joint_name(&scene, lower).length), "lower");
  EXPECT_EQ(sinew_find_joint(&scene, "tail"), SINEW_NONE);
  EXPECT_EQ(sinew_find_joint(&scene, nullptr), SINEW_NONE);
  EXPECT_EQ(sinew_joint_name(&scene, 99).length, 0u);

  const std::uint32_t bend = sinew_find_clip(&scene, "bend");
  ASSERT_EQ(bend, 0u);
  EXPECT_EQ(sinew_clip_duration_s(&scene, bend), 1.0);
  EXPECT_EQ(sinew_clip_duration_s(&scene, 7), 0.0);
  EXPECT_EQ(sinew_find_mesh(&scene, scene.scene.meshes[0].name.c_str()), 0u);

  sinew_instance instance{.struct_size = sizeof(instance)};
  ASSERT_EQ(sinew_get_instance(&scene, 0, &instance), SINEW_OK);
  EXPECT_EQ(instance.skin, 0u);
  EXPECT_EQ(instance.joint, sinew_find_joint(&scene, "holder"));
  EXPECT_EQ(sinew_get_instance(&scene, 1, &instance), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(sinew_skin_joints(&scene, 0).count, 2u);

  sinew_primitive primitive{.struct_size = sizeof(primitive)};
  ASSERT_EQ(sinew_get_primitive(&scene, 0, 0, &primitive), SINEW_OK);
  const Primitive& arm = scene.scene.meshes[0].primitives[0];
  EXPECT_EQ(primitive.positions.data, reinterpret_cast<const sinew_vec3*>(arm.positions.data()));
  EXPECT_EQ(primitive.positions.count, 4u);
  EXPECT_EQ(primitive.indices.count, arm.indices.size());
  EXPECT_EQ(primitive.topology, static_cast<std::uint32_t>(SINEW_TRIANGLES));
  EXPECT_EQ(sinew_get_primitive(&scene, 0, 1, &primitive), SINEW_INDEX_OUT_OF_RANGE);
}

TEST(c_interface, influences_are_those_of_the_vertex) {
  const sinew_scene scene = random_handle(5);
  std::size_t seen = 0;
  for (std::uint32_t m = 0; m < scene.scene.meshes.size(); ++m) {
    const Primitive& primitive = scene.scene.meshes[m].primitives[0];
    for (const InfluenceGroup& group : primitive.influences.groups)
      for (std::uint32_t i = 0; i < group.vertex_count; ++i) {
        const sinew_influences found = sinew_vertex_influences(&scene, m, 0, group.first_vertex + i);
        ASSERT_EQ(found.count, group.influence_count);
        EXPECT_EQ(found.joints, &primitive.influences.joints[group.first_influence + i * group.influence_count]);
        EXPECT_EQ(found.weights, &primitive.influences.weights[group.first_influence + i * group.influence_count]);
        ++seen;
      }
    EXPECT_EQ(sinew_vertex_influences(&scene, m, 0, static_cast<std::uint32_t>(primitive.vertex_count())).count, 0u);
  }
  EXPECT_GT(seen, 20u);
}

TEST(c_interface, stages_and_frame_memory_are_those_of_the_plan) {
  const sinew_scene scene = random_handle(6);
  sinew_plan* plan = nullptr;
  ASSERT_EQ(sinew_plan_create(&scene, nullptr, &plan), SINEW_OK);
  const Plan in_cpp = compile_plan(lend(scene.scene), {});
  EXPECT_GE(sinew_plan_frame_bytes(plan), in_cpp.frame_bytes());
  const std::vector<PlanStage> expected = in_cpp.stages();
  ASSERT_EQ(sinew_stage_count(plan), expected.size());
  for (std::uint32_t s = 0; s < expected.size(); ++s) {
    sinew_stage stage{.struct_size = sizeof(stage)};
    ASSERT_EQ(sinew_get_stage(plan, s, &stage), SINEW_OK);
    EXPECT_EQ(std::string_view(stage.name.data, stage.name.length), expected[s].stage);
    EXPECT_EQ(std::string_view(stage.reason.data, stage.reason.length), expected[s].reason);
    EXPECT_EQ(stage.runs != 0, expected[s].runs);
    EXPECT_EQ(stage.count, expected[s].count);
    EXPECT_EQ(stage.bytes, expected[s].bytes);
  }
  sinew_plan_destroy(plan);
}

TEST(c_interface, frame_memory_comes_from_the_engine_alone) {
  const sinew_scene scene = random_handle(7);
  const sinew_needs needs = all_needs();
  const sinew_frame_input input = layered_input();
  sinew_plan* plan = nullptr;
  ASSERT_EQ(sinew_plan_create(&scene, &needs, &plan), SINEW_OK);
  engine_memory memory{.allocations = 0, .bytes_in_use = 0, .most_bytes = 0, .refuse_after = 1};
  const sinew_allocator allocator = engine_allocator(&memory);
  const AllocationCounter others;
  sinew_frame* frame = nullptr;
  ASSERT_EQ(sinew_frame_create(plan, &allocator, &frame), SINEW_OK);
  for (int i = 0; i < 3; ++i) ASSERT_EQ(sinew_run(frame, i == 1 ? nullptr : &input), SINEW_OK);
  EXPECT_EQ(others.count(), 0u);
  EXPECT_EQ(memory.allocations, 1u);
  EXPECT_EQ(memory.bytes_in_use, sinew_plan_frame_bytes(plan));
  sinew_frame* second = nullptr;
  EXPECT_EQ(sinew_frame_create(plan, &allocator, &second), SINEW_OUT_OF_MEMORY);  // the engine's allocator fails
  EXPECT_EQ(second, nullptr);
  sinew_frame_destroy(frame);
  EXPECT_EQ(memory.bytes_in_use, 0u);
  EXPECT_EQ(others.count(), 0u);
  sinew_plan_destroy(plan);
}

TEST(c_interface, jobs_run_on_the_engines_executor_and_memory_with_the_same_bits) {
  const sinew_scene scene = random_handle(8);
  const sinew_needs needs = all_needs();
  sinew_plan* plan = nullptr;
  ASSERT_EQ(sinew_plan_create(&scene, &needs, &plan), SINEW_OK);
  engine_memory memory{.allocations = 0, .bytes_in_use = 0, .most_bytes = 0, .refuse_after = 100};
  engine_executor_log log{};
  sinew_jobs_options options = sinew_default_jobs_options();
  options.allocator = engine_allocator(&memory);
  options.executor = engine_executor(&log);
  options.inline_below_bytes = 0;
  options.part_bytes = 1;  // so that each character is a job of its own
  sinew_jobs* jobs = nullptr;
  ASSERT_EQ(sinew_jobs_create(&options, &jobs), SINEW_OK);
  for (std::uint32_t expected = 0; expected < 3; ++expected) {
    std::uint32_t character = 99;
    ASSERT_EQ(sinew_jobs_add_character(jobs, plan, &character), SINEW_OK);
    EXPECT_EQ(character, expected);
  }
  EXPECT_GE(memory.bytes_in_use, 3 * 3 * compile_plan(lend(scene.scene), all_needs_in_cpp()).frame_bytes());
  EXPECT_EQ(sinew_jobs_latest(jobs, 0), nullptr);
  sinew_frame_input inputs[3] = {layered_input(), sinew_default_input(), layered_input()};
  inputs[2].root.row[1][3] = 5.0f;
  const std::size_t allocations = memory.allocations;
  for (std::uint64_t frame = 1; frame < 5; ++frame) {
    std::uint64_t ticket = 0;
    ASSERT_EQ(sinew_jobs_submit(jobs, inputs, 3, &ticket), SINEW_OK);
    EXPECT_EQ(ticket, frame);
    ASSERT_EQ(sinew_jobs_wait(jobs, ticket), SINEW_OK);
    EXPECT_TRUE(sinew_jobs_done(jobs, ticket));
  }
  EXPECT_EQ(memory.allocations, allocations);
  EXPECT_EQ(log.calls, 4u);
  EXPECT_EQ(log.indices, 12u);
  EXPECT_EQ(sinew_jobs_wait(jobs, 5), SINEW_INDEX_OUT_OF_RANGE);
  for (std::uint32_t c = 0; c < 3; ++c) {
    Numbers read, alone;
    ASSERT_EQ(engine_read(sinew_jobs_latest(jobs, c), sinew_skin_count(&scene), &read), SINEW_OK);
    ASSERT_EQ(engine_play(&scene, &needs, &inputs[c], nullptr, &alone), SINEW_OK);
    expect_same(read.all(), alone.all());
  }
  sinew_jobs_destroy(jobs);
  EXPECT_EQ(memory.bytes_in_use, 0u);
  sinew_plan_destroy(plan);
}

TEST(c_interface, a_character_without_memory_is_not_added_and_the_next_one_takes_its_place) {
  const sinew_scene scene = random_handle(9);
  sinew_plan* plan = nullptr;
  ASSERT_EQ(sinew_plan_create(&scene, nullptr, &plan), SINEW_OK);
  engine_memory memory{.allocations = 0, .bytes_in_use = 0, .most_bytes = 0, .refuse_after = 100};
  sinew_jobs_options options = sinew_default_jobs_options();
  options.allocator = engine_allocator(&memory);
  sinew_jobs* jobs = nullptr;
  ASSERT_EQ(sinew_jobs_create(&options, &jobs), SINEW_OK);
  memory.refuse_after = memory.allocations;
  std::uint32_t character = 99;
  EXPECT_EQ(sinew_jobs_add_character(jobs, plan, &character), SINEW_OUT_OF_MEMORY);
  EXPECT_EQ(character, 99u);
  memory.refuse_after = 100;
  ASSERT_EQ(sinew_jobs_add_character(jobs, plan, &character), SINEW_OK);
  EXPECT_EQ(character, 0u);
  const sinew_frame_input input = sinew_default_input();
  std::uint64_t ticket = 0;
  ASSERT_EQ(sinew_jobs_submit(jobs, &input, 1, &ticket), SINEW_OK);
  ASSERT_EQ(sinew_jobs_wait(jobs, ticket), SINEW_OK);
  EXPECT_NE(sinew_jobs_latest(jobs, 0), nullptr);
  sinew_jobs_destroy(jobs);
  EXPECT_EQ(memory.bytes_in_use, 0u);
  sinew_plan_destroy(plan);
}

TEST(c_interface, clocks_and_events_are_those_of_the_cpp_interface) {
  const double times_s[] = {0.0, 0.3, 0.31, 1.0};
  for (std::uint32_t mode = SINEW_PLAY_LOOP; mode <= SINEW_PLAY_ONCE; ++mode) {
    std::uint32_t events[64];
    double end_s = 0.0;
    const std::size_t crossed = engine_events(1.0, mode, 0.17, 20, times_s, 4, events, 64, &end_s);
    PlaybackClock clock(1.0, static_cast<PlayMode>(mode));
    std::vector<std::uint32_t> expected;
    for (int i = 0; i < 20; ++i)
      for (EventCursor cursor(clock.advance(0.17), times_s); const auto event = cursor.next();)
        expected.push_back(static_cast<std::uint32_t>(*event));
    EXPECT_EQ(std::vector<std::uint32_t>(events, events + crossed), expected) << mode;
    EXPECT_EQ(end_s, clock.time_s());
    EXPECT_EQ(engine_events(1.0, mode, 0.17, 20, times_s, 4, events, 3, &end_s),
              expected.size());  // it counts all events, also those beyond the capacity
  }
}

TEST(c_interface, bad_calls_answer_codes_and_change_nothing) {
  const sinew_scene scene{arm_scene()};
  sinew_plan* plan = nullptr;
  sinew_needs needs = sinew_default_needs();
  const auto refuses = [&](auto change, sinew_error error) {
    sinew_needs bad = sinew_default_needs();
    change(bad);
    EXPECT_EQ(sinew_plan_create(&scene, &bad, &plan), error) << sinew_describe(error);
    EXPECT_EQ(plan, nullptr);
  };
  const float nan_mask[] = {1.0f, 1.0f, std::nanf("")};
  refuses([](sinew_needs& n) { n.struct_size = 4; }, SINEW_WRONG_STRUCT_SIZE);
  refuses([](sinew_needs& n) { n.flags |= 1u << 31; }, SINEW_UNSUPPORTED);
  refuses([](sinew_needs& n) { n.max_layers = 0; }, SINEW_UNSUPPORTED);
  refuses([](sinew_needs& n) { n.skinning = 3; }, SINEW_UNSUPPORTED);
  refuses([](sinew_needs& n) { n.mask_count = 1; }, SINEW_NULL_ARGUMENT);
  refuses(
      [&](sinew_needs& n) {
        n.mask_count = 1;
        n.masks = nan_mask;
      },
      SINEW_NOT_FINITE);
  EXPECT_EQ(sinew_plan_create(nullptr, &needs, &plan), SINEW_NULL_ARGUMENT);
  ASSERT_EQ(sinew_plan_create(&scene, &needs, &plan), SINEW_OK);

  sinew_frame* frame = nullptr;
  ASSERT_EQ(sinew_frame_create(plan, nullptr, &frame), SINEW_OK);
  ASSERT_EQ(sinew_run(frame, nullptr), SINEW_OK);
  const auto run = [&](sinew_layer layer, std::size_t count = 1) {
    const std::vector<sinew_layer> layers(count, layer);
    sinew_frame_input input = sinew_default_input();
    input.layers = layers.data();
    input.layer_count = count;
    return sinew_run(frame, &input);
  };
  EXPECT_EQ(run({0.5, 7, SINEW_NONE, 1.0f, 0}), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(run({0.5, 0, SINEW_NONE, -1.0f, 0}), SINEW_NEGATIVE_WEIGHT);
  EXPECT_EQ(run({0.5, 0, SINEW_NONE, 1.0f, 9}), SINEW_UNSUPPORTED);
  EXPECT_EQ(run({std::nan(""), 0, SINEW_NONE, 1.0f, 0}), SINEW_NOT_FINITE);
  EXPECT_EQ(run({0.5, 0, SINEW_NONE, 1.0f, 0}, 5), SINEW_TOO_MANY_LAYERS);
  sinew_result_info info{.struct_size = sizeof(info)};
  ASSERT_EQ(sinew_get_result(sinew_frame_result(frame), &info), SINEW_OK);
  EXPECT_EQ(info.frame, 1u);
  info.struct_size = 8;
  EXPECT_EQ(sinew_get_result(sinew_frame_result(frame), &info), SINEW_WRONG_STRUCT_SIZE);
  sinew_shape shape{.struct_size = sizeof(shape)};
  EXPECT_EQ(sinew_get_shape(sinew_frame_result(frame), 1, &shape), SINEW_INDEX_OUT_OF_RANGE);
  sinew_frame_destroy(frame);
  sinew_frame_destroy(nullptr);
  sinew_plan_destroy(plan);
}

TEST(c_interface, a_newer_caller_works_while_it_uses_nothing_new) {
  struct NewerNeeds {
    sinew_needs known = sinew_default_needs();
    std::uint64_t added = 0;
  } newer;
  struct NewerShape {
    sinew_shape known{};
    std::uint64_t added = 7;
  } shape;
  newer.known.struct_size = sizeof(newer);
  shape.known.struct_size = sizeof(shape);
  const sinew_scene scene{arm_scene()};
  sinew_plan* plan = nullptr;
  sinew_frame* frame = nullptr;
  ASSERT_EQ(sinew_plan_create(&scene, &newer.known, &plan), SINEW_OK);
  ASSERT_EQ(sinew_frame_create(plan, nullptr, &frame), SINEW_OK);
  ASSERT_EQ(sinew_run(frame, nullptr), SINEW_OK);
  EXPECT_EQ(sinew_get_shape(sinew_frame_result(frame), 0, &shape.known), SINEW_OK);
  EXPECT_EQ(shape.known.positions.count, 4u);
  EXPECT_EQ(shape.added, 0u);
  EXPECT_EQ(shape.known.struct_size, sizeof(shape));
  sinew_frame_destroy(frame);
  sinew_plan_destroy(plan);
  plan = nullptr;
  newer.added = 1;
  EXPECT_EQ(sinew_plan_create(&scene, &newer.known, &plan), SINEW_WRONG_STRUCT_SIZE);
}

TEST(c_interface, every_error_has_a_sentence_and_the_version_is_the_headers) {
  EXPECT_EQ(sinew_version(), static_cast<std::uint32_t>(SINEW_VERSION));
  for (int error = SINEW_OK; error <= SINEW_OUTSIDE_OF_CLIP; ++error)
    EXPECT_EQ(sinew_describe(static_cast<sinew_error>(error)), describe(static_cast<ErrorCode>(error)));
  for (const sinew_error error : {SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_OUT_OF_MEMORY, SINEW_BAD_FILE})
    EXPECT_GT(std::strlen(sinew_describe(error)), 10u);
  EXPECT_STREQ(sinew_describe(static_cast<sinew_error>(77)), "unknown error");
}

}  // namespace
}  // namespace sinew::test
