// SPDX-License-Identifier: MIT
// Pose programs through the C interface give the bits of those in C++, wherever inputs go. C code in engine_program.c
// writes the program and is its procedure.
#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>
#include <utility>

#include "runtime/c/page_handle.h"
#include "tests/c/program_actor.h"
#include "tests/support/allocation_counter.h"

namespace sinew::test {
namespace {

using c_pose_programs = ProgramActor;

TEST_F(c_pose_programs, overlays_poses_joints_and_procedures_have_the_bits_of_cpp) {
  ASSERT_EQ(sinew_run(frame_, nullptr), SINEW_OK);
  const std::vector<float> rest = all_numbers_of(sinew_frame_result(frame_));
  for (const std::uint8_t space :
       {std::uint8_t{SINEW_OVERRIDE_LOCAL}, std::uint8_t{SINEW_OVERRIDE_MODEL}, std::uint8_t{SINEW_OVERRIDE_WORLD}}) {
    joint_.space = space;
    ++overrides_.version;
    ASSERT_EQ(sinew_run(frame_, &input_), SINEW_OK) << why();
    const std::vector<float> numbers = all_numbers_of(sinew_frame_result(frame_));
    EXPECT_TRUE(same_bits<float>(numbers, numbers_by_cpp())) << int{space};
    EXPECT_FALSE(same_bits<float>(numbers, rest));
  }
}

TEST_F(c_pose_programs, equal_versions_run_nothing) {
  sinew_result_info info{.struct_size = sizeof(info)};
  const auto since = [&] {
    EXPECT_EQ(sinew_run(frame_, &input_), SINEW_OK) << why();
    EXPECT_EQ(sinew_get_result(sinew_frame_result(frame_), &info), SINEW_OK);
    return info.since_frame;
  };
  EXPECT_EQ(since(), 1u);
  EXPECT_EQ(since(), 1u);
  height_ = 3.0f;
  EXPECT_EQ(since(), 1u) << "its version promises that nothing changed";
  ++procedure_.version;
  EXPECT_EQ(since(), 4u);
}

TEST_F(c_pose_programs, frames_allocate_nothing_and_stay_in_their_block) {
  const AllocationCounter allocations;
  sinew_cut_pose cut{.struct_size = sizeof(cut)};
  EXPECT_EQ(sinew_run(frame_, &input_), SINEW_OK);
  EXPECT_EQ(sinew_run_to_cut(frame_, &input_, 3, &cut), SINEW_OK);
  EXPECT_EQ(sinew_run_from_cut(frame_, &input_), SINEW_OK);
  EXPECT_EQ(allocations.count(), 0u);
  const sinew_needs needs = needs_of_c();
  Numbers in_block, expected;
  ASSERT_EQ(engine_play_in_block(&scene_, &needs, &input_, &in_block), SINEW_OK);
  ASSERT_EQ(engine_read(sinew_frame_result(frame_), 2, &expected), SINEW_OK);
  EXPECT_TRUE(same_bits<float>(in_block.all(), expected.all()));
}

TEST_F(c_pose_programs, jobs_run_what_was_submitted_whatever_the_caller_writes_later) {
  const std::vector<float> expected = numbers_by_cpp();
  sinew_jobs_options options = sinew_default_jobs_options();
  options.own_thread = 0;
  sinew_jobs* jobs = nullptr;
  std::uint32_t character = 0;
  ASSERT_EQ(sinew_jobs_create(&options, &jobs), SINEW_OK);
  ASSERT_EQ(sinew_jobs_add_character(jobs, plan_, &character), SINEW_OK);
  ASSERT_EQ(sinew_jobs_submit(jobs, &input_, 1, nullptr), SINEW_OK);
  joint_.transform.translation.x += 1.0f;
  for (float& weight : mask_weights_) weight = 0.0f;
  for (float& weight : weights_) weight = 0.0f;
  ASSERT_EQ(sinew_pose_rest(&scene_, &pose_), SINEW_OK);
  for (sinew_pose_op& op : ops_) op = sinew_default_op(SINEW_OP_REST);
  inputs_ = {.struct_size = sizeof(inputs_)};
  ASSERT_EQ(sinew_jobs_poll(jobs), 1);
  ASSERT_EQ(sinew_jobs_last_error(jobs), SINEW_OK);
  EXPECT_TRUE(same_bits<float>(all_numbers_of(sinew_jobs_latest(jobs, 0)), expected));
  sinew_jobs_destroy(jobs);
}

TEST_F(c_pose_programs, layers_name_masks_of_the_input) {
  const sinew_layer layers[] = {{0.3, 0, SINEW_NONE, 0.5f, SINEW_LAYER_BLEND}, {0.4, 1, 1, 0.5f, SINEW_LAYER_BLEND}};
  input_ = sinew_default_input();
  input_.layers = layers;
  input_.layer_count = 2;
  EXPECT_EQ(sinew_run(frame_, &input_), SINEW_INDEX_OUT_OF_RANGE);
  input_.program_inputs = &inputs_;
  ASSERT_EQ(sinew_run(frame_, &input_), SINEW_OK);
  const OfCpp cpp(*this);
  const ClipLayer own[] = {{0, 0.3, 0.5f}, {1, 0.4, 0.5f, 1}};
  FrameInput input{.layers = own, .weights = {}, .root = {}};
  input.program_inputs.masks = {&cpp.mask, 1};
  FrameBuffer frame(cpp.plan);
  ASSERT_EQ(run_plan(cpp.plan, input, frame), ErrorCode::ok);
  EXPECT_TRUE(same_bits<float>(all_numbers_of(sinew_frame_result(frame_)),
                               all_numbers_of(reinterpret_cast<const sinew_result*>(&frame.result()))));
  sinew_held_input* held = nullptr;
  ASSERT_EQ(sinew_held_input_create(plan_, &held), SINEW_OK);
  sinew_frame_input next = sinew_default_input();
  ASSERT_EQ(sinew_held_input_next(held, &input_, SINEW_UPDATE_EVERY, 0, 0, &next), SINEW_OK);
  ASSERT_EQ(next.program_inputs->mask_count, 1u);
  EXPECT_EQ(sinew_run(frame_, &next), SINEW_OK) << "a held input keeps its masks";
  sinew_held_input_destroy(held);
}

// A walk fades into a run while both step over an event: each is told once, with its weight at that moment.
TEST_F(c_pose_programs, events_of_all_clips_of_a_program_come_in_the_order_of_time) {
  sinew_pose_op ops[] = {sinew_default_op(SINEW_OP_SAMPLE), sinew_default_op(SINEW_OP_SAMPLE),
                         sinew_default_op(SINEW_OP_MEAN)};
  ops[0].weight = 0.25f;
  ops[1].weight = 0.75f;
  ops[2].index = 2;
  float shares[3] = {};
  ASSERT_EQ(sinew_op_shares(ops, 3, shares), SINEW_OK);
  EXPECT_EQ(std::vector<float>(shares, shares + 3), (std::vector<float>{0.25f, 0.75f, 1.0f}));
  ops[2].index = 3;
  EXPECT_EQ(sinew_op_shares(ops, 3, shares), SINEW_SIZE_MISMATCH);
  EXPECT_EQ(sinew_op_shares(ops, 3, nullptr), SINEW_NULL_ARGUMENT);

  const double walk[] = {0.2, 0.8}, run[] = {0.5};
  std::vector<sinew_playing_clip> playing = {{{}, walk, 2, 1.0, 1.0f, shares[0]}, {{}, run, 1, 1.0, 0.0f, shares[1]}};
  for (sinew_playing_clip& clip : playing) {
    sinew_clock clock;
    ASSERT_EQ(sinew_clock_init(&clock, 1.0, SINEW_PLAY_LOOP, 1.0), SINEW_OK);
    ASSERT_EQ(sinew_clock_advance(&clock, 1.0, &clip.step), SINEW_OK);
  }
  sinew_blended_event events[3];
  std::size_t crossed = 0;
  ASSERT_EQ(sinew_blended_events(playing.data(), 2, events, 3, &crossed), SINEW_OK);
  ASSERT_EQ(crossed, 3u);
  const sinew_blended_event expected[] = {{0, 0, 0.2, 0.85f}, {1, 0, 0.5, 0.375f}, {0, 1, 0.8, 0.4f}};
  for (std::size_t e = 0; e < 3; ++e) {
    EXPECT_EQ(events[e].clip, expected[e].clip);
    EXPECT_EQ(events[e].event, expected[e].event);
    EXPECT_NEAR(events[e].moment, expected[e].moment, 1e-12);
    EXPECT_NEAR(events[e].weight, expected[e].weight, 1e-6f);
  }
  ASSERT_EQ(sinew_blended_events(playing.data(), 2, events, 1, &crossed), SINEW_OK);
  EXPECT_EQ(crossed, 3u) << "more than there is room for";
  EXPECT_EQ(sinew_blended_events(nullptr, 2, events, 3, &crossed), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_blended_events(playing.data(), 2, nullptr, 3, &crossed), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_blended_events(playing.data(), 2, events, 3, nullptr), SINEW_NULL_ARGUMENT);
  playing[1].event_times_s = nullptr;
  EXPECT_EQ(sinew_blended_events(playing.data(), 2, events, 3, &crossed), SINEW_NULL_ARGUMENT);
  playing.assign(256, playing[0]);
  EXPECT_EQ(sinew_blended_events(playing.data(), 256, events, 3, &crossed), SINEW_UNSUPPORTED);
}

TEST_F(c_pose_programs, held_inputs_hold_programs) {
  const std::vector<float> expected = numbers_by_cpp();
  sinew_held_input* held = nullptr;
  ASSERT_EQ(sinew_held_input_create(plan_, &held), SINEW_OK);
  sinew_frame_input next = sinew_default_input();
  ASSERT_EQ(sinew_held_input_next(held, &input_, SINEW_UPDATE_EVERY_FOURTH, 0, 0, &next), SINEW_OK);
  joint_.transform.translation.x += 1.0f;
  for (float& weight : mask_weights_) weight = 0.0f;
  ASSERT_EQ(sinew_held_input_next(held, &input_, SINEW_UPDATE_EVERY_FOURTH, 1, 0, &next), SINEW_OK);
  ASSERT_EQ(sinew_run(frame_, &next), SINEW_OK);
  EXPECT_TRUE(same_bits<float>(all_numbers_of(sinew_frame_result(frame_)), expected));
  --external_.pose.joint_count;
  ++external_.version;
  ASSERT_EQ(sinew_held_input_next(held, &input_, SINEW_UPDATE_EVERY_FOURTH, 4, 0, &next), SINEW_OK);
  EXPECT_EQ(sinew_run(frame_, &next), SINEW_SIZE_MISMATCH) << "it is not held but handed on";
  input_.op_count = 0;
  ASSERT_EQ(sinew_held_input_next(held, &input_, SINEW_UPDATE_EVERY_FOURTH, 8, 0, &next), SINEW_OK);
  EXPECT_EQ(next.program, nullptr);
  EXPECT_EQ(sinew_run(frame_, &next), SINEW_OK);
  sinew_held_input_destroy(held);
}

TEST_F(c_pose_programs, programs_are_evaluated_in_every_frame_between_updates) {
  sinew_needs needs = needs_of_c();
  needs.flags |= SINEW_NEED_BETWEEN_UPDATES;
  sinew_plan* plan = nullptr;
  sinew_frame* frame = nullptr;
  sinew_interpolated_input* interpolated = nullptr;
  ASSERT_EQ(sinew_plan_create(&scene_, &needs, &plan), SINEW_OK);
  ASSERT_EQ(sinew_frame_create(plan, nullptr, &frame), SINEW_OK);
  ASSERT_EQ(sinew_interpolated_input_create(plan, &interpolated), SINEW_OK);
  sinew_frame_input next = sinew_default_input();
  ASSERT_EQ(sinew_interpolated_input_next(interpolated, &input_, nullptr, 0, SINEW_UPDATE_EVERY_FOURTH, 1, 0, &next),
            SINEW_OK);
  ASSERT_EQ(sinew_run(frame, &next), SINEW_OK);
  EXPECT_TRUE(same_bits<float>(all_numbers_of(sinew_frame_result(frame)), numbers_by_cpp()));
  sinew_interpolated_input_destroy(interpolated);
  sinew_frame_destroy(frame);
  sinew_plan_destroy(plan);
}

TEST_F(c_pose_programs, pages_stand_for_the_clips_of_operations) {
  ops_[0].time_s = 0.0;
  ASSERT_EQ(sinew_run(frame_, &input_), SINEW_OK);
  const std::vector<float> expected = all_numbers_of(sinew_frame_result(frame_));
  const auto page_of_scene = [&](const sinew_scene& scene, sinew_paged_clip*& paged, sinew_page*& page) {
    ASSERT_EQ(sinew_paged_clip_create(&scene, 0, 0.1, 9, nullptr, &paged), SINEW_OK);
    ASSERT_EQ(sinew_page_create(&page), SINEW_OK);
    ASSERT_EQ(sinew_paged_clip_at(paged, 0.0, 0, page), SINEW_OK);
  };
  const sinew_scene smaller{random_scene(3, {.joints = 5})};
  sinew_paged_clip *paged = nullptr, *other_paged = nullptr;
  sinew_page *page = nullptr, *other_page = nullptr;
  page_of_scene(scene_, paged, page);
  page_of_scene(smaller, other_paged, other_page);
  const sinew_page* pages[engine_program_ops] = {page};
  inputs_.pages = pages;
  sinew_frame* frame = nullptr;
  ASSERT_EQ(sinew_frame_create(plan_, nullptr, &frame), SINEW_OK);
  ASSERT_EQ(sinew_run(frame, &input_), SINEW_OK) << why();
  EXPECT_TRUE(same_bits<float>(all_numbers_of(sinew_frame_result(frame)), expected));
  pages[0] = other_page;
  EXPECT_EQ(why(), std::string("pages[0]: ") + sinew_describe(SINEW_WRONG_PAGE));
  for (sinew_page* own : {page, other_page}) sinew_page_destroy(own);
  for (sinew_paged_clip* own : {paged, other_paged}) sinew_paged_clip_destroy(own);
  sinew_frame_destroy(frame);
}

TEST_F(c_pose_programs, cuts_go_on_from_what_the_caller_writes) {
  const OfCpp cpp(*this);
  FrameBuffer frame(cpp.plan);
  CutPose expected;
  sinew_cut_pose cut{.struct_size = sizeof(cut)};
  ASSERT_EQ(run_to_cut(cpp.plan, cpp.input, frame, expected, 3), ErrorCode::ok);
  ASSERT_EQ(sinew_run_to_cut(frame_, &input_, 3, &cut), SINEW_OK);
  ASSERT_EQ(cut.model.count, joints());
  EXPECT_EQ(std::memcmp(cut.model.data, expected.model.data(), expected.model.size_bytes()), 0);
  Transform moved = expected.local.get(1);
  moved.translation = {3.0f, 2.0f, 1.0f};
  expected.local.set(1, moved);
  ASSERT_EQ(engine_place(&cut, {3.0f, 2.0f, 1.0f}), SINEW_OK);
  ASSERT_EQ(run_from_cut(cpp.plan, cpp.input, frame), ErrorCode::ok);
  ASSERT_EQ(sinew_run_from_cut(frame_, &input_), SINEW_OK);
  const std::vector<float> numbers = all_numbers_of(sinew_frame_result(frame_));
  EXPECT_TRUE(same_bits<float>(numbers, all_numbers_of(reinterpret_cast<const sinew_result*>(&frame.result()))));
  EXPECT_FALSE(same_bits<float>(numbers, numbers_by_cpp()));
}

TEST_F(c_pose_programs, cuts_are_refused_out_of_order_and_without_needs) {
  sinew_cut_pose cut{.struct_size = sizeof(cut)}, of_no_version{.struct_size = 3};
  EXPECT_EQ(sinew_run_from_cut(frame_, &input_), SINEW_NO_CUT);
  EXPECT_EQ(sinew_run_to_cut(frame_, &input_, 0, &cut), SINEW_UNSUPPORTED);
  EXPECT_EQ(sinew_run_to_cut(frame_, &input_, 3, &of_no_version), SINEW_WRONG_STRUCT_SIZE);
  EXPECT_EQ(sinew_run_from_cut(frame_, &input_), SINEW_NO_CUT);
  ASSERT_EQ(sinew_run_to_cut(frame_, &input_, 3, &cut), SINEW_OK);
  sinew_frame_input other = input_;
  const sinew_program_inputs none{.struct_size = sizeof(none)};
  other.program_inputs = &none;
  EXPECT_EQ(sinew_run_from_cut(frame_, &other), SINEW_INDEX_OUT_OF_RANGE) << "another input than before the cut";
  EXPECT_EQ(sinew_run_from_cut(frame_, &input_), SINEW_OK) << "the cut is still there";
  ASSERT_EQ(sinew_run_to_cut(frame_, &input_, 3, &cut), SINEW_OK);
  cut.local.planes[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(sinew_run_from_cut(frame_, &input_), SINEW_NOT_FINITE);
  sinew_needs needs = needs_of_c();
  needs.flags &= ~static_cast<std::uint32_t>(SINEW_NEED_CUT);
  sinew_plan* plan = nullptr;
  sinew_frame* frame = nullptr;
  ASSERT_EQ(sinew_plan_create(&scene_, &needs, &plan), SINEW_OK);
  ASSERT_EQ(sinew_frame_create(plan, nullptr, &frame), SINEW_OK);
  EXPECT_EQ(sinew_run_to_cut(frame, &input_, 3, &cut), SINEW_NOT_IN_NEEDS);
  EXPECT_EQ(cut.local.planes, nullptr);
  sinew_frame_destroy(frame);
  sinew_plan_destroy(plan);
}

TEST(c_program_rooms, are_those_of_cpp_and_can_be_raised) {
  const sinew_pose_op ops[] = {{0.0, 1.0f, 2, 4, SINEW_OP_EXTERNAL},
                               {0.5, 1.0f, 0, SINEW_OP_NO_MASK, SINEW_OP_SAMPLE},
                               {0.0, 1.0f, 0, SINEW_OP_NO_MASK, SINEW_OP_OVERLAY_MODEL}};
  const sinew_pose_op other[] = {sinew_default_op(SINEW_OP_REST), sinew_default_op(SINEW_OP_PROCEDURE),
                                 sinew_default_op(SINEW_OP_CACHED)};
  sinew_program_room room{.struct_size = sizeof(room)}, more = room;
  ASSERT_EQ(sinew_program_room_of(ops, 3, &room), SINEW_OK);
  ASSERT_EQ(sinew_program_room_of(other, 3, &more), SINEW_OK);
  more.overridden_joints = 7;
  ASSERT_EQ(sinew_raise_program_room(&room, &more), SINEW_OK);
  EXPECT_EQ(room.struct_size, sizeof(room));
  const std::uint32_t numbers[] = {room.ops,        room.slots, room.externals,         room.overrides,
                                   room.procedures, room.masks, room.overridden_joints, room.overlays_in_model_space,
                                   room.kept};
  const std::uint32_t expected[] = {3, 2, 3, 0, 1, 5, 7, 1, 1};
  EXPECT_TRUE(std::equal(std::begin(numbers), std::end(numbers), std::begin(expected)));
  more.struct_size = 3;
  EXPECT_EQ(sinew_program_room_of(ops, 3, &more), SINEW_WRONG_STRUCT_SIZE);
  EXPECT_EQ(sinew_raise_program_room(&room, &more), SINEW_WRONG_STRUCT_SIZE);
  EXPECT_EQ(sinew_program_room_of(nullptr, 1, &room), SINEW_NULL_ARGUMENT);
}

TEST(c_transitions, by_default_have_one_step_and_begin) {
  for (const sinew_op_kind kind : {SINEW_OP_INERTIALIZE, SINEW_OP_DEAD_BLEND}) {
    const sinew_pose_op op = sinew_default_op(kind);
    EXPECT_EQ(op.index, 1u);
    EXPECT_EQ(op.time_s, 0.0);
    EXPECT_EQ(op.weight, 1.0f);
  }
}

TEST_F(c_pose_programs, rooms_that_no_program_can_use_are_refused) {
  const sinew_needs needs = needs_of_c();
  const sinew_program_room good = room_;
  sinew_plan* plan = nullptr;
  const std::pair<std::uint32_t sinew_program_room::*, std::uint32_t> too_many[] = {
      {&sinew_program_room::ops, 256u},         {&sinew_program_room::slots, 256u},
      {&sinew_program_room::masks, 256u},       {&sinew_program_room::externals, 65536u},
      {&sinew_program_room::overrides, 65536u}, {&sinew_program_room::procedures, 65536u},
      {&sinew_program_room::kept, 256u}};
  for (const auto& [member, number] : too_many) {
    room_ = good;
    room_.*member = number;
    EXPECT_EQ(sinew_plan_create(&scene_, &needs, &plan), SINEW_UNSUPPORTED);
  }
  room_ = good;
  room_.slots = room_.ops + 1;  // no program leaves more poses than it has operations
  EXPECT_EQ(sinew_plan_create(&scene_, &needs, &plan), SINEW_UNSUPPORTED);
  room_ = good;
  room_.masks = 255;
  ASSERT_EQ(sinew_plan_create(&scene_, &needs, &plan), SINEW_OK);
  sinew_plan_destroy(plan);
  plan = nullptr;
  const std::vector<float> masks(256 * joints(), 1.0f);
  sinew_needs masked = needs;
  masked.masks = masks.data();
  masked.mask_count = 256;
  EXPECT_EQ(sinew_plan_create(&scene_, &masked, &plan), SINEW_UNSUPPORTED);
  masked.mask_count = 255;
  ASSERT_EQ(sinew_plan_create(&scene_, &masked, &plan), SINEW_OK);
  sinew_plan_destroy(plan);
  plan = nullptr;
  room_ = good;
  room_.struct_size = 3;
  EXPECT_EQ(sinew_plan_create(&scene_, &needs, &plan), SINEW_WRONG_STRUCT_SIZE);
  EXPECT_EQ(plan, nullptr);
}

TEST_F(c_pose_programs, joints_of_poses_count_those_that_a_skeleton_lod_keeps) {
  for (std::uint32_t j = 0; j < joints(); ++j) EXPECT_EQ(sinew_pose_joint(plan_, j), j);
  EXPECT_EQ(sinew_pose_joint(plan_, static_cast<std::uint32_t>(joints())), SINEW_NONE);
  EXPECT_EQ(sinew_pose_joint(nullptr, 0), SINEW_NONE);
  sinew_skeleton_lod* lod = nullptr;
  sinew_skeleton_lod_info info{.struct_size = sizeof(info)};
  ASSERT_EQ(sinew_skeleton_lod_create(&scene_, 1e9, nullptr, 0, nullptr, &lod), SINEW_OK);
  ASSERT_EQ(sinew_get_skeleton_lod(lod, &info), SINEW_OK);
  ASSERT_GT(info.left_out, 0u);
  sinew_needs needs = needs_of_c();
  needs.skeleton_lod = lod;
  sinew_plan* plan = nullptr;
  ASSERT_EQ(sinew_plan_create(&scene_, &needs, &plan), SINEW_OK);
  std::uint32_t kept = 0;
  for (std::uint32_t j = 0; j < joints(); ++j)
    EXPECT_EQ(sinew_pose_joint(plan, j), info.kept.data[j] != 0 ? kept++ : SINEW_NONE);
  sinew_plan_destroy(plan);
  sinew_skeleton_lod_destroy(lod);
}

}  // namespace
}  // namespace sinew::test
