// SPDX-License-Identifier: MIT
// No call of the C interface crashes: null pointers and nonsense numbers give error codes, or nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "runtime/c/handles.h"
#include "tests/c/c_frame.h"
#include "tests/c/engine.h"
#include "tests/scenes/hand_scenes.h"

namespace sinew::test {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
const double kNotNumbers[] = {std::nan(""), kInfinite, -kInfinite};

TEST(c_bad_calls, null_scenes_and_plans_hold_nothing) {
  EXPECT_EQ(sinew_joint_count(nullptr), 0u);
  EXPECT_EQ(sinew_joint_name(nullptr, 0).length, 0u);
  EXPECT_EQ(sinew_joint_parent(nullptr, 0), SINEW_NONE);
  EXPECT_EQ(sinew_find_joint(nullptr, "a"), SINEW_NONE);
  EXPECT_EQ(sinew_clip_count(nullptr), 0u);
  EXPECT_EQ(sinew_clip_name(nullptr, 0).length, 0u);
  EXPECT_EQ(sinew_clip_duration_s(nullptr, 0), 0.0);
  EXPECT_EQ(sinew_find_clip(nullptr, "a"), SINEW_NONE);
  EXPECT_EQ(sinew_skin_count(nullptr), 0u);
  EXPECT_EQ(sinew_skin_joints(nullptr, 0).count, 0u);
  EXPECT_EQ(sinew_mesh_count(nullptr), 0u);
  EXPECT_EQ(sinew_mesh_name(nullptr, 0).length, 0u);
  EXPECT_EQ(sinew_find_mesh(nullptr, "a"), SINEW_NONE);
  EXPECT_EQ(sinew_primitive_count(nullptr, 0), 0u);
  EXPECT_EQ(sinew_target_count(nullptr, 0), 0u);
  EXPECT_EQ(sinew_target_name(nullptr, 0, 0).length, 0u);
  EXPECT_EQ(sinew_instance_count(nullptr), 0u);
  EXPECT_EQ(sinew_weight_count(nullptr), 0u);
  EXPECT_EQ(sinew_get_instance(nullptr, 0, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_get_primitive(nullptr, 0, 0, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_primitive_texcoords(nullptr, 0, 0, 0).count, 0u);
  EXPECT_EQ(sinew_vertex_influences(nullptr, 0, 0, 0).count, 0u);
  EXPECT_EQ(sinew_stage_count(nullptr), 0u);
  EXPECT_EQ(sinew_get_stage(nullptr, 0, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_plan_frame_bytes(nullptr), 0u);
  EXPECT_EQ(sinew_message_count(nullptr), 0u);
  EXPECT_STREQ(sinew_message(nullptr, 0), "");
}

TEST(c_bad_calls, null_frames_jobs_and_results_answer_codes) {
  sinew_affine affine;
  EXPECT_EQ(sinew_run(nullptr, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_frame_result(nullptr), nullptr);
  EXPECT_EQ(sinew_get_result(nullptr, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_get_palette(nullptr, 0).count, 0u);
  EXPECT_EQ(sinew_get_instance_result(nullptr, 0, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_get_shape(nullptr, 0, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_world_of(nullptr, nullptr, 0, nullptr, &affine), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_jobs_submit(nullptr, nullptr, 0, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_jobs_add_character(nullptr, nullptr, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_jobs_wait(nullptr, 1), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_jobs_last_error(nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_jobs_latest(nullptr, 0), nullptr);
  EXPECT_FALSE(sinew_jobs_done(nullptr, 0));
  EXPECT_FALSE(sinew_jobs_poll(nullptr));
  EXPECT_FALSE(sinew_jobs_take_task(nullptr, nullptr));
  const sinew_task no_task{};
  sinew_task_run(nullptr);
  sinew_task_run(&no_task);
  sinew_frame_prefetch(nullptr);
  sinew_frame_write_past_caches(nullptr, 1);
  sinew_interpolated_input_restart(nullptr);
  sinew_frame_input input{.struct_size = sizeof(input)};
  EXPECT_EQ(sinew_held_input_create(nullptr, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_held_input_next(nullptr, nullptr, 0, 0, 0, &input), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_interpolated_input_create(nullptr, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_interpolated_input_next(nullptr, nullptr, nullptr, 0, 0, 0, 0, &input), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_clips_save(nullptr, 0, 0, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_clips_load(nullptr, 0, nullptr, 0, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_clip_block_bytes(nullptr).count, 0u);
  EXPECT_FALSE(sinew_looks_like_clips(nullptr, 40));
  EXPECT_EQ(sinew_clip_bounds(nullptr, nullptr, 0, nullptr, 0, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_skeleton_lod_create(nullptr, 0.0, nullptr, 0, nullptr, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_get_skeleton_lod(nullptr, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_choose_update_level(0.1, 0, 0.0, nullptr, nullptr), SINEW_NULL_ARGUMENT);
}

TEST(c_bad_calls, destroying_null_does_nothing) {
  sinew_scene_destroy(nullptr);
  sinew_plan_destroy(nullptr);
  sinew_frame_destroy(nullptr);
  sinew_jobs_destroy(nullptr);
  sinew_clip_block_destroy(nullptr);
  sinew_skeleton_lod_destroy(nullptr);
  sinew_held_input_destroy(nullptr);
  sinew_interpolated_input_destroy(nullptr);
  sinew_messages_destroy(nullptr);
}

TEST(c_bad_calls, clocks_refuse_what_they_cannot_count) {
  sinew_clock clock{};
  sinew_step step;
  for (const double bad : kNotNumbers) {
    EXPECT_EQ(sinew_clock_init(&clock, bad, SINEW_PLAY_LOOP, 1.0), SINEW_NOT_FINITE);
    EXPECT_EQ(sinew_clock_init(&clock, 1.0, SINEW_PLAY_LOOP, bad), SINEW_NOT_FINITE);
  }
  EXPECT_EQ(sinew_clock_init(&clock, 1.0, 4, 1.0), SINEW_UNSUPPORTED);
  ASSERT_EQ(sinew_clock_init(&clock, 1.0, SINEW_PLAY_LOOP, 1e200), SINEW_OK);
  for (const double bad : kNotNumbers) {
    EXPECT_EQ(sinew_clock_advance(&clock, bad, &step), SINEW_NOT_FINITE);
    EXPECT_EQ(sinew_clock_seek(&clock, bad), SINEW_NOT_FINITE);
    EXPECT_EQ(sinew_clock_set_speed(&clock, bad), SINEW_NOT_FINITE);
  }
  EXPECT_EQ(sinew_clock_advance(&clock, 1e200, &step), SINEW_NOT_FINITE) << "speed times step";
  EXPECT_EQ(sinew_clock_time_s(&clock), 0.0) << "and the clock stands";
  EXPECT_EQ(sinew_clock_advance(nullptr, 0.1, &step), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_clock_time_s(nullptr), 0.0);
  EXPECT_EQ(sinew_clock_rounds(nullptr), 0);
  EXPECT_FALSE(sinew_clock_finished(nullptr));
  std::uint32_t event = 0;
  const double time_s = 0.0;
  EXPECT_EQ(sinew_crossed_events(nullptr, &time_s, 1, &event, 1), 0u);
  step = {};
  EXPECT_EQ(sinew_crossed_events(&step, nullptr, 3, &event, 1), 0u);
  ASSERT_EQ(sinew_clock_init(&clock, 1.0, SINEW_PLAY_LOOP, 1.0), SINEW_OK);
  ASSERT_EQ(sinew_clock_advance(&clock, 0.5, &step), SINEW_OK);
  EXPECT_EQ(sinew_crossed_events(&step, &time_s, 1, nullptr, 9), 1u) << "counted without room for them";
}

TEST(c_bad_calls, needs_are_checked_from_the_first_number_to_the_last) {
  const sinew_scene scene{arm_scene()};  // three joints, one instance
  sinew_plan* plan = nullptr;
  const auto answer = [&](const auto& change) {
    sinew_needs needs = sinew_default_needs();
    change(needs);
    return sinew_plan_create(&scene, &needs, &plan);
  };
  for (const float bad : {std::nanf(""), static_cast<float>(kInfinite), -0.5f})
    for (std::size_t i = 0; i < 6; ++i) {
      std::vector<float> masks(6, 1.0f);
      masks[i] = bad;
      EXPECT_EQ(answer([&](sinew_needs& n) {
                  n.mask_count = 2;
                  n.masks = masks.data();
                }),
                SINEW_NOT_FINITE)
          << i;
    }
  const std::uint8_t unknown = SINEW_SKIN_CENTER_OF_ROTATION + 1;
  EXPECT_EQ(answer([&](sinew_needs& n) { n.instance_skinning = &unknown; }), SINEW_UNSUPPORTED);
  EXPECT_EQ(answer([](sinew_needs& n) { n.mask_count = 1; }), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(answer([](sinew_needs& n) { n.max_layers = 0; }), SINEW_UNSUPPORTED);
  EXPECT_EQ(answer([](sinew_needs& n) { n.skinning = SINEW_SKIN_CENTER_OF_ROTATION + 1; }), SINEW_UNSUPPORTED);
  EXPECT_EQ(answer([](sinew_needs& n) { n.normal_rule = SINEW_NORMALS_COFACTOR + 1; }), SINEW_UNSUPPORTED);
  EXPECT_EQ(answer([](sinew_needs& n) { n.flags = ~0u; }), SINEW_UNSUPPORTED);
  EXPECT_EQ(plan, nullptr);
}

TEST(c_bad_calls, frames_take_as_many_adding_layers_as_were_asked_for) {
  const sinew_scene scene{arm_scene()};
  sinew_needs needs = sinew_default_needs();
  needs.flags |= SINEW_NEED_ADDITIVE;
  needs.max_layers = needs.max_adding_layers = 1;
  sinew_plan* plan = nullptr;
  sinew_frame* frame = nullptr;
  ASSERT_EQ(sinew_plan_create(&scene, &needs, &plan), SINEW_OK);
  ASSERT_EQ(sinew_frame_create(plan, nullptr, &frame), SINEW_OK);
  const sinew_layer adds{0.5, 0, SINEW_NONE, 1.0f, SINEW_LAYER_ADD_TO_REST};
  const sinew_layer layers[] = {{0.5, 0, SINEW_NONE, 1.0f, SINEW_LAYER_BLEND}, adds, adds};
  sinew_frame_input input = sinew_default_input();
  input.layers = layers;
  for (const std::size_t count : {1u, 2u}) {
    input.layer_count = count;
    EXPECT_EQ(sinew_run(frame, &input), SINEW_OK) << count;
  }
  sinew_instance_result placed{.struct_size = sizeof(placed)};
  EXPECT_EQ(sinew_get_instance_result(sinew_frame_result(frame), 0, &placed), SINEW_OK);
  EXPECT_EQ(sinew_get_instance_result(sinew_frame_result(frame), 1, &placed), SINEW_INDEX_OUT_OF_RANGE);
  input.layer_count = 3;
  EXPECT_EQ(sinew_run(frame, &input), SINEW_TOO_MANY_LAYERS);
  sinew_frame_destroy(frame);
  sinew_plan_destroy(plan);
}

TEST(c_bad_calls, root_motion_refuses_what_does_not_exist) {
  const sinew_scene scene{arm_scene()};
  sinew_dual_quat out;
  sinew_step step{};
  for (const double bad : kNotNumbers) EXPECT_EQ(sinew_root_place(&scene, 0, 0, nullptr, bad, &out), SINEW_NOT_FINITE);
  EXPECT_EQ(sinew_root_place(&scene, 5, 0, nullptr, 0.0, &out), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(sinew_root_place(&scene, 0, 9, nullptr, 0.0, &out), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(sinew_root_place(&scene, 0, 0, nullptr, 0.0, nullptr), SINEW_NULL_ARGUMENT);
  sinew_root_parts parts = sinew_default_root_parts();
  parts.turn = 4;
  EXPECT_EQ(sinew_root_place(&scene, 0, 0, &parts, 0.0, &out), SINEW_UNSUPPORTED);
  EXPECT_EQ(sinew_root_motion(nullptr, 0, 0, nullptr, &step, &out), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_root_motion(&scene, 0, 0, nullptr, nullptr, &out), SINEW_NULL_ARGUMENT);
  for (double& number : step.inside) number = std::nan("");
  EXPECT_NE(sinew_root_motion(&scene, 0, 0, nullptr, &step, &out), SINEW_OK) << "no clock made that";
}

TEST(c_bad_calls, root_tracks_refuse_what_does_not_exist) {
  const sinew_scene scene{arm_scene()};
  sinew_library* library = nullptr;
  ASSERT_EQ(sinew_library_create(&scene, &library), SINEW_OK);
  sinew_root_track* track = nullptr;
  const auto create = [&](std::uint32_t clip, std::uint32_t joint, const sinew_root_parts* parts) {
    return sinew_root_track_create(&scene, library, clip, joint, parts, &track);
  };
  EXPECT_EQ(create(0, 0, nullptr), SINEW_INDEX_OUT_OF_RANGE) << "the library is empty";
  ASSERT_EQ(sinew_library_add(library, &scene, SINEW_REFUSE, nullptr), SINEW_OK);
  EXPECT_EQ(create(0, 9, nullptr), SINEW_INDEX_OUT_OF_RANGE);
  sinew_root_parts parts = sinew_default_root_parts();
  parts.turn = 4;
  EXPECT_EQ(create(0, 0, &parts), SINEW_UNSUPPORTED);
  EXPECT_EQ(sinew_root_track_create(nullptr, library, 0, 0, nullptr, &track), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_root_track_create(&scene, nullptr, 0, 0, nullptr, &track), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_root_track_create(&scene, library, 0, 0, nullptr, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(track, nullptr);
  ASSERT_EQ(create(0, 0, nullptr), SINEW_OK);
  sinew_dual_quat out;
  sinew_step step{};
  for (const double bad : kNotNumbers) EXPECT_EQ(sinew_root_track_place(track, bad, &out), SINEW_NOT_FINITE);
  EXPECT_EQ(sinew_root_track_place(nullptr, 0.0, &out), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_root_track_place(track, 0.0, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_root_track_motion(nullptr, &step, &out), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_root_track_motion(track, nullptr, &out), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_root_track_motion(track, &step, nullptr), SINEW_NULL_ARGUMENT);
  for (double& number : step.inside) number = std::nan("");
  EXPECT_NE(sinew_root_track_motion(track, &step, &out), SINEW_OK) << "no clock made that";
  sinew_root_track_destroy(track);
  sinew_root_track_destroy(nullptr);
  sinew_library_destroy(library);
}

struct c_bad_calls_of_a_plan : CPlan {
  c_bad_calls_of_a_plan() : CPlan(arm_scene()) {}
};

TEST_F(c_bad_calls_of_a_plan, interpolation_needs_a_plan_that_has_it) {
  const sinew_layer layer{0.5, 0, SINEW_NONE, 1.0f, 0};
  sinew_frame_input input = sinew_default_input();
  input.next_layers = &layer;
  input.next_layer_count = 1;
  EXPECT_EQ(sinew_run(frame_, &input), SINEW_OK) << "not looked at while the factor is 0";
  input.interpolation_factor = 0.5f;
  EXPECT_EQ(sinew_run(frame_, &input), SINEW_NOT_IN_NEEDS);
  sinew_interpolated_input* interpolated = nullptr;
  EXPECT_EQ(sinew_interpolated_input_create(plan_, &interpolated), SINEW_NOT_IN_NEEDS);
  EXPECT_EQ(interpolated, nullptr);

  sinew_needs needs = sinew_default_needs();
  needs.flags |= SINEW_NEED_BETWEEN_UPDATES;
  sinew_plan* between = nullptr;
  sinew_frame* between_frame = nullptr;
  ASSERT_EQ(sinew_plan_create(&scene_, &needs, &between), SINEW_OK);
  ASSERT_EQ(sinew_frame_create(between, nullptr, &between_frame), SINEW_OK);
  EXPECT_EQ(sinew_run(between_frame, &input), SINEW_OK);
  for (const float bad : {-0.1f, 1.1f, std::nanf("")}) {
    input.interpolation_factor = bad;
    EXPECT_EQ(sinew_run(between_frame, &input), SINEW_NOT_A_FRACTION);
  }
  input.interpolation_factor = 0.5f;
  input.next_layer_count = 5;
  EXPECT_EQ(sinew_run(between_frame, &input), SINEW_TOO_MANY_LAYERS);
  input.next_layers = nullptr;
  EXPECT_EQ(sinew_run(between_frame, &input), SINEW_NULL_ARGUMENT);
  sinew_frame_destroy(between_frame);
  sinew_plan_destroy(between);
}

TEST_F(c_bad_calls_of_a_plan, sockets_need_joints) {
  sinew_affine out;
  const sinew_result* result = sinew_frame_result(frame_);
  EXPECT_EQ(sinew_world_of(plan_, result, 0, nullptr, &out), SINEW_UNSUPPORTED) << "nothing was run";
  ASSERT_EQ(sinew_run(frame_, nullptr), SINEW_OK);
  EXPECT_EQ(sinew_world_of(plan_, result, 0, nullptr, &out), SINEW_OK);
  EXPECT_EQ(sinew_world_of(plan_, result, 3, nullptr, &out), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(sinew_world_of(plan_, result, 0, nullptr, nullptr), SINEW_NULL_ARGUMENT);
  const sinew_scene prop{prop_scene()};
  sinew_plan* other = nullptr;
  ASSERT_EQ(sinew_plan_create(&prop, nullptr, &other), SINEW_OK);
  EXPECT_EQ(sinew_world_of(other, result, 0, nullptr, &out), SINEW_SIZE_MISMATCH);
  sinew_plan_destroy(other);
}

TEST_F(c_bad_calls_of_a_plan, held_inputs_that_are_asleep_stay_so) {
  sinew_held_input* held = nullptr;
  ASSERT_EQ(sinew_held_input_create(plan_, &held), SINEW_OK);
  sinew_frame_input now = sinew_default_input(), next = sinew_default_input();
  for (const std::uint32_t asleep : {1u, 0u, 1u}) {
    now.asleep = asleep;
    ASSERT_EQ(sinew_held_input_next(held, &now, SINEW_UPDATE_EVERY, 0, 0, &next), SINEW_OK);
    EXPECT_EQ(next.asleep, asleep);
  }
  sinew_held_input_destroy(held);
}

TEST_F(c_bad_calls_of_a_plan, levels_that_do_not_exist_are_refused) {
  sinew_held_input* held = nullptr;
  ASSERT_EQ(sinew_held_input_create(plan_, &held), SINEW_OK);
  sinew_frame_input input{.struct_size = sizeof(input)};
  EXPECT_EQ(sinew_held_input_next(held, nullptr, 3, 0, 0, &input), SINEW_UNSUPPORTED);
  input.struct_size = 3;
  EXPECT_EQ(sinew_held_input_next(held, nullptr, 0, 0, 0, &input), SINEW_WRONG_STRUCT_SIZE);
  sinew_frame_input next = sinew_default_input();
  EXPECT_EQ(sinew_held_input_next(held, &input, 0, 0, 0, &next), SINEW_WRONG_STRUCT_SIZE) << "of the input itself";
  sinew_held_input_destroy(held);
  EXPECT_EQ(sinew_frames_to_update(3, 0, 0), 0u);
  std::uint32_t level = 0;
  EXPECT_EQ(sinew_choose_update_level(0.1, 3, 0.0, nullptr, &level), SINEW_UNSUPPORTED);
  EXPECT_EQ(sinew_choose_update_level(std::nan(""), 0, 0.0, nullptr, &level), SINEW_NOT_FINITE);
}

TEST_F(c_bad_calls_of_a_plan, skeleton_lods_refuse_bad_numbers_and_other_scenes) {
  sinew_skeleton_lod* lod = nullptr;
  for (const double bad : {std::nan(""), kInfinite, -0.1})
    EXPECT_EQ(sinew_skeleton_lod_create(&scene_, bad, nullptr, 0, nullptr, &lod), SINEW_NOT_FINITE);
  const std::uint32_t clip = 7;
  EXPECT_EQ(sinew_skeleton_lod_create(&scene_, 0.1, &clip, 1, nullptr, &lod), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(lod, nullptr);
  ASSERT_EQ(sinew_skeleton_lod_create(&scene_, 100.0, nullptr, 0, nullptr, &lod), SINEW_OK);
  const sinew_scene prop{prop_scene()};
  sinew_needs needs = sinew_default_needs();
  needs.skeleton_lod = lod;
  sinew_plan* other = nullptr;
  EXPECT_EQ(sinew_plan_create(&prop, &needs, &other), SINEW_SIZE_MISMATCH);
  sinew_skeleton_lod_destroy(lod);
}

TEST_F(c_bad_calls_of_a_plan, jobs_refuse_numbers_that_make_no_sense) {
  sinew_jobs_options options = sinew_default_jobs_options();
  sinew_jobs* jobs = nullptr;
  for (const std::uint32_t buffers : {0u, 1u, 4u, 258u}) {
    options.frame_buffers = buffers;
    EXPECT_EQ(sinew_jobs_create(&options, &jobs), SINEW_UNSUPPORTED);
  }
  ASSERT_EQ(sinew_jobs_create(nullptr, &jobs), SINEW_OK);
  std::uint32_t character = 0;
  ASSERT_EQ(sinew_jobs_add_character(jobs, plan_, &character), SINEW_OK);
  EXPECT_EQ(sinew_jobs_latest(jobs, 1), nullptr);
  EXPECT_EQ(sinew_jobs_wait(jobs, 9), SINEW_INDEX_OUT_OF_RANGE);
  const std::vector<float> weights(100, 0.0f);
  sinew_frame_input input = sinew_default_input();
  input.weights = {weights.data(), weights.size()};
  EXPECT_EQ(sinew_jobs_submit(jobs, &input, 1, nullptr), SINEW_SIZE_MISMATCH);
  EXPECT_EQ(sinew_jobs_submit(jobs, nullptr, 1, nullptr), SINEW_NULL_ARGUMENT);
  sinew_jobs_destroy(jobs);
}

}  // namespace
}  // namespace sinew::test
