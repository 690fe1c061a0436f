// SPDX-License-Identifier: MIT
// Pose programs in frames. The test run_pose_program holds the operations themselves to their equations.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "runtime/base/same_bits.h"
#include "runtime/math/axis_angle.h"
#include "runtime/plan/cut_frame.h"
#include "runtime/plan/input_copy.h"
#include "runtime/pose/local_to_model.h"
#include "runtime/pose/pose_memory.h"
#include "tests/plan/frame_equality.h"
#include "tests/plan/program_scene.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/scenes/random_scene.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

using Actor = ProgramScene;

TEST(pose_programs, layers_give_the_bits_of_the_program_that_they_stand_for) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Actor actor(seed);
    const ClipLayer layers[] = {{0, 0.3, 0.5f},
                                {1, 0.7, 0.3f, 0},
                                {0, 0.4, 0.25f, kNone, LayerKind::add_to_rest},
                                {1, 0.2, 0.5f, 0, LayerKind::add_to_start},
                                {1, 0.9, 0.0f}};
    PoseProgram program;
    program.sample(0, 0.3, 0.5f).sample(1, 0.7, 0.3f, 0).mean(2);
    program.sample(0, 0.4, 0.25f).add_to_rest();
    program.sample(1, 0.2, 0.5f, 0).sample(1, 0.0).add();
    FrameBuffer by_layers(actor.plan), by_program(actor.plan);
    ASSERT_EQ(run_plan(actor.plan, {.layers = layers, .weights = {}, .root = {}}, by_layers), ErrorCode::ok);
    ASSERT_EQ(run_plan(actor.plan, actor.input(program), by_program), ErrorCode::ok);
    EXPECT_EQ(first_difference(by_layers.result(), by_program.result()), "") << seed;
    EXPECT_EQ(by_layers.result().work, by_program.result().work);
  }
}

// Operations count clips by 16 bits. Layers name clips beyond that all the same.
TEST(pose_programs, layers_name_more_clips_than_operations_can) {
  const Actor actor(4);
  std::vector<Clip> clips(70'000, actor.scene.clips[0]);
  clips.back() = actor.scene.clips[1];
  const auto last = static_cast<std::uint32_t>(clips.size() - 1);
  const Plan few = compile_plan(lend(actor.scene), actor.plan.needs());
  const Plan many = compile_plan(lend(actor.scene), clips, actor.plan.needs());
  FrameBuffer of_few(few), of_many(many);
  for (const LayerKind kind : {LayerKind::blend, LayerKind::add_to_rest, LayerKind::add_to_start}) {
    const ClipLayer expected{1, 0.3, 1.0f, kNone, kind}, named{last, 0.3, 1.0f, kNone, kind};
    ASSERT_EQ(run_plan(few, {.layers = {&expected, 1}, .weights = {}, .root = {}}, of_few), ErrorCode::ok);
    ASSERT_EQ(run_plan(many, {.layers = {&named, 1}, .weights = {}, .root = {}}, of_many), ErrorCode::ok);
    EXPECT_TRUE(same_bits<Affine>(of_few.result().model, of_many.result().model));
  }
  EXPECT_EQ(run_plan(many, actor.input(PoseProgram().sample(65'534, 0.1)), of_many), ErrorCode::ok);
  for (const std::uint32_t beyond : {65'535u, 65'536u, last})
    EXPECT_EQ(run_plan(many, actor.input(PoseProgram().sample(beyond, 0.1)), of_many), ErrorCode::index_out_of_range);
}

// Two frames whose cached operands hold a joint still in the world while the character walks away.
TEST(pose_programs, joints_in_world_space_stay_there_while_the_root_moves) {
  Actor actor(3);
  Needs needs = actor.plan.needs();
  needs.in.program.kept = 1;
  const Plan plan = compile_plan(lend(actor.scene), needs);
  actor.joint.space = OverrideSpace::world;
  const PoseProgram program = PoseProgram().sample(0, 0.3).override_joints(0).cached();
  FrameBuffer kept(plan);
  for (const float way : {0.0f, 2.5f, 2.5f}) {
    FrameInput input = actor.input(program);
    input.root.row[0].w = way;
    FrameBuffer fresh(plan);
    ASSERT_EQ(run_plan(plan, input, kept), ErrorCode::ok) << why_refused(plan, input, kept);
    ASSERT_EQ(run_plan(plan, input, fresh), ErrorCode::ok);
    EXPECT_EQ(first_difference(fresh.result(), kept.result()), "") << way;
    EXPECT_LT(glm::distance(translation_of(kept.result().model[actor.joint.joint]), actor.joint.transform.translation),
              2e-5f);
  }
}

TEST(pose_programs, a_plan_has_up_to_255_masks) {
  const Actor actor(4);
  Needs needs = actor.plan.needs();
  needs.in.masks.assign(255, std::vector<float>(actor.scene.skeleton.joint_count(), 0.0f));
  needs.in.masks.back().assign(actor.scene.skeleton.joint_count(), 1.0f);
  const Plan plan = compile_plan(lend(actor.scene), needs);
  FrameBuffer masked(plan), unmasked(plan);
  const ClipLayer last{0, 0.3, 1.0f, 254}, none{0, 0.3, 1.0f};
  ASSERT_EQ(run_plan(plan, {.layers = {&last, 1}, .weights = {}, .root = {}}, masked), ErrorCode::ok);
  ASSERT_EQ(run_plan(plan, {.layers = {&none, 1}, .weights = {}, .root = {}}, unmasked), ErrorCode::ok);
  for (std::size_t j = 0; j < actor.scene.skeleton.joint_count(); ++j)
    EXPECT_LT(glm::distance(masked.result().local.get(j).translation, unmasked.result().local.get(j).translation),
              1e-5f);
}

TEST(pose_programs, world_matrices_follow_from_the_local_pose_of_the_result) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Actor actor(seed);
    PoseProgram program;
    program.sample(0, 0.3, 0.5f).external(0, 0.5f).mean(2).override_joints(0);
    for (const PoseProgramSpan ops : {program.ops(), PoseProgramSpan{}}) {
      FrameInput input = actor.input(program);
      input.program = ops;
      input.root.row[1].w = 2.0f;
      FrameBuffer frame(actor.plan);
      ASSERT_EQ(run_plan(actor.plan, input, frame), ErrorCode::ok);
      std::vector<Affine> model(actor.scene.skeleton.joint_count());
      ASSERT_EQ(run(LocalToModelJob{&actor.scene.skeleton, frame.result().local, input.root, model}), ErrorCode::ok);
      EXPECT_TRUE(same_bits<Affine>(frame.result().model, model)) << seed;
    }
  }
}

// A mean of layers rounds joints that no clip moves; the local pose has them at rest, in the first frame and later.
TEST(pose_programs, the_local_pose_of_mixed_layers_has_unmoved_joints_at_rest_to_the_bit) {
  std::size_t unmoved = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Scene scene = random_scene(seed);
    move_few_joints(scene);
    const Plan plan = compile_plan(lend(scene), Needs{});
    FrameBuffer frame(plan);
    for (int f = 0; f < 3; ++f) {
      const ClipLayer layers[] = {{0, 0.1 * f, 0.3f}, {1, 0.2 * f, 0.4f}};
      ASSERT_EQ(run_plan(plan, {.layers = layers, .weights = {}, .root = {}}, frame), ErrorCode::ok);
      FrameBuffer resting(plan);
      ASSERT_EQ(run_plan(plan, {}, resting), ErrorCode::ok);
      const std::span<const std::uint32_t> moved = plan.moved_joints();
      for (std::uint32_t j = 0; j < scene.skeleton.joint_count(); ++j) {
        if (std::binary_search(moved.begin(), moved.end(), j)) continue;
        ++unmoved;
        EXPECT_TRUE(same_bits(frame.result().local.get(j), resting.result().local.get(j))) << seed << ' ' << f;
      }
    }
  }
  EXPECT_GT(unmoved, 0u);
}

TEST(pose_programs, frames_whose_local_pose_nobody_needs_have_the_same_bits) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Scene scene = random_scene(seed);
    move_few_joints(scene);
    const Plan with = compile_plan(lend(scene), {}),
               without = compile_plan(lend(scene), {.out = {.local_pose = false}});
    FrameBuffer shown(with), hidden(without);
    for (int f = 0; f < 4; ++f) {
      const ClipLayer layers[] = {{0, 0.1 * f, 0.3f}, {1, 0.2 * f, 0.4f}};
      FrameInput input{.layers = layers};
      if (f == 2) input.root.row[0].w = 1.0f;  // all matrices are made again
      ASSERT_EQ(run_plan(with, input, shown), ErrorCode::ok);
      ASSERT_EQ(run_plan(without, input, hidden), ErrorCode::ok);
      EXPECT_EQ(first_difference(shown.result(), hidden.result()), "") << seed << ' ' << f;
      EXPECT_EQ(hidden.result().local.planes, nullptr);
      EXPECT_NE(shown.result().local.planes, nullptr);
    }
  }
}

TEST(pose_programs, a_plan_for_the_local_pose_alone_plays_clips) {
  const Scene scene = arm_scene();
  const Plan plan = compile_plan(lend(scene), {.out = {.joints = false,
                                                       .positions = false,
                                                       .normals = false,
                                                       .tangents = false,
                                                       .weights = false,
                                                       .properties = false}});
  FrameBuffer frame(plan);
  const ClipLayer layers[] = {{0, 1.0}};
  ASSERT_EQ(run_plan(plan, {.layers = layers}, frame), ErrorCode::ok);
  EXPECT_EQ(frame.result().local.get(2).rotation, scene.animations[0].bones[0].rotation.values[1]);
}

TEST(pose_programs, a_pose_and_a_joint_of_the_caller_reach_matrices_weights_and_vertices) {
  const Actor actor(3);
  FrameBuffer frame(actor.plan);
  ASSERT_EQ(run_plan(actor.plan, actor.input(PoseProgram().external(0)), frame), ErrorCode::ok);
  for (std::size_t j = 0; j < actor.scene.skeleton.joint_count(); ++j)
    EXPECT_EQ(frame.result().local.get(j), actor.external.pose.get(j));
  EXPECT_TRUE(same_bits<float>(frame.result().weights, actor.pose_weights));
  EXPECT_EQ(frame.result().work.poses_copied, 1u);
  ASSERT_EQ(run_plan(actor.plan, actor.input(PoseProgram().external(0).override_joints(0)), frame), ErrorCode::ok);
  EXPECT_EQ(frame.result().local.get(actor.joint.joint), actor.joint.transform);
  EXPECT_EQ(frame.result().work.joints_overridden, 1u);
}

// All frames into one buffer have the bits of a frame into a new one, whatever ran before.
TEST(pose_programs, what_stands_since_the_frame_before_has_the_bits_of_a_new_frame) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Actor actor(seed);
    FixedRandom random(seed);
    FrameBuffer frame(actor.plan);
    const PoseProgram programs[] = {PoseProgram().sample(0, 0.3), PoseProgram().external(0).override_joints(0),
                                    PoseProgram().sample(0, 0.3).sample(1, 0.5, 0.75f, 1).overlay_model(),
                                    PoseProgram().sample(1, 0.1, 0.5f).mean(1)};
    const ClipLayer layer{0, 0.3};
    for (int i = 0; i < 60; ++i) {
      FrameInput input = actor.input(programs[random.below(4)]);
      if (random.below(4) == 0) {
        input = {};
        if (random.below(2) == 0) input.layers = {&layer, 1};
      }
      if (random.below(4) == 0) {
        actor.joint.transform.translation.x += 0.1f;
        ++actor.overrides.version;
      }
      FrameBuffer fresh(actor.plan);
      ASSERT_EQ(run_plan(actor.plan, input, frame), ErrorCode::ok) << why_refused(actor.plan, input, frame);
      ASSERT_EQ(run_plan(actor.plan, input, fresh), ErrorCode::ok);
      ASSERT_EQ(first_difference(frame.result(), fresh.result()), "") << seed << ' ' << i;
      for (std::size_t j = 0; j < frame.result().local.joint_count; ++j)
        ASSERT_TRUE(same_bits(frame.result().local.get(j), fresh.result().local.get(j))) << j;
    }
  }
}

TEST(pose_programs, the_same_program_and_versions_run_nothing_and_version_0_promises_nothing) {
  Actor actor(5);
  PoseProgram program;
  program.sample(0, 0.3).external(0, 0.5f, 1).overlay().override_joints(0);
  FrameBuffer frame(actor.plan);
  const auto work = [&] {
    EXPECT_EQ(run_plan(actor.plan, actor.input(program), frame), ErrorCode::ok);
    return frame.result().work;
  };
  EXPECT_EQ(work().poses_overlaid, 1u);
  EXPECT_TRUE(holds_result_of(frame, actor.input(program)));
  EXPECT_EQ(work(), WorkCounters{}) << "nothing changed";
  for (ContentVersion* version : {&actor.external.version, &actor.overrides.version, &actor.mask.version}) {
    *version = 2;
    EXPECT_EQ(work().poses_overlaid, 1u);
    EXPECT_EQ(work(), WorkCounters{});
  }
  actor.external.version = 0;
  EXPECT_EQ(work().poses_overlaid, 1u);
  EXPECT_EQ(work().poses_overlaid, 1u) << "version 0 may be anything";
  EXPECT_EQ(frame.result().work.vertices_skinned_linear, 0u) << "the same matrices deform nothing";
}

TEST(pose_programs, frames_allocate_nothing) {
  const Actor actor(6, true);
  PoseProgram program;
  program.sample(0, 0.3).external(0, 0.5f, 1).overlay_model().sample(1, 0.4, 0.5f).add_to_rest().override_joints(0);
  FrameBuffer frame(actor.plan);
  InputCopy copy(actor.plan);
  const AllocationCounter allocations;
  const FrameInput input = actor.input(program);
  EXPECT_EQ(run_plan(actor.plan, input, frame), ErrorCode::ok);
  CutPose pose;
  EXPECT_EQ(run_to_cut(actor.plan, input, frame, pose, 2), ErrorCode::ok);
  EXPECT_EQ(run_from_cut(actor.plan, input, frame), ErrorCode::ok);
  EXPECT_EQ(copy.check_room(input), ErrorCode::ok);
  copy.assign(input);
  EXPECT_EQ(run_plan(actor.plan, copy.view(), frame), ErrorCode::ok);
  EXPECT_EQ(allocations.count(), 0u);
}

TEST(pose_programs, refusals_name_the_list_the_entry_and_the_rule) {
  Actor actor(7);
  FrameBuffer frame(actor.plan);
  const auto refused = [&](const FrameInput& input, ErrorCode code, const std::string& sentence) {
    EXPECT_EQ(why_refused(actor.plan, input, frame), sentence);
    EXPECT_EQ(run_plan(actor.plan, input, frame), code) << sentence;
  };
  PoseProgram long_program;
  long_program.rest();
  for (int i = 0; i < 12; ++i) long_program.rest().add_to_rest();
  refused(actor.input(long_program), ErrorCode::not_in_needs, "program: it has more operations than the needs declare");
  refused(actor.input(PoseProgram().rest().sample(99, 0.1).overlay()), ErrorCode::index_out_of_range,
          "program[1]: there is no clip of that index");
  refused(actor.input(PoseProgram().sample(0, 0.1, 2e9f).mean(1)), ErrorCode::too_large,
          "program[0].weight: " + std::string(describe(ErrorCode::too_large)));
  refused(actor.input(PoseProgram().rest().procedure(0)), ErrorCode::index_out_of_range,
          "program[1]: there is no procedure of that index");
  const ClipLayer layer;
  FrameInput both = actor.input(PoseProgram().rest());
  both.layers = {&layer, 1};
  refused(both, ErrorCode::unsupported, "program: layers are given as well");
  const JointOverrides two[] = {actor.overrides, actor.overrides};
  FrameInput many = actor.input(PoseProgram().rest());
  many.program_inputs.overrides = two;
  refused(many, ErrorCode::not_in_needs, "overrides: longer than the needs declare");
  actor.joint.transform.translation.y = std::numeric_limits<float>::quiet_NaN();
  refused(actor.input(PoseProgram().rest()), ErrorCode::not_finite, "overrides[0]: a transform is not finite");
  const Plan closed = compile_plan(lend(actor.scene), Needs{});
  FrameBuffer of_closed(closed);
  EXPECT_EQ(why_refused(closed, actor.input(PoseProgram().rest()), of_closed),
            "program: the needs declare no programs");
}

TEST(pose_programs, a_copy_of_the_input_does_not_follow_what_the_caller_writes_later) {
  Actor actor(8);
  PoseProgram program;
  program.external(0).override_joints(0).sample(0, 0.2, 1.0f, 1).overlay();
  FrameBuffer expected(actor.plan), frame(actor.plan);
  ASSERT_EQ(run_plan(actor.plan, actor.input(program), expected), ErrorCode::ok);
  InputCopy copy(actor.plan);
  ASSERT_EQ(copy.check_room(actor.input(program)), ErrorCode::ok);
  copy.assign(actor.input(program));
  actor.joint.transform.translation.x += 1.0f;
  for (float& weight : actor.mask_weights) weight = 0.0f;
  for (float& weight : actor.pose_weights) weight = 0.0f;
  actor.pose_memory.span().set(0, {});
  program.clear();
  ASSERT_EQ(run_plan(actor.plan, copy.view(), frame), ErrorCode::ok);
  EXPECT_EQ(first_difference(expected.result(), frame.result()), "");
  ExternalPose smaller = actor.external;
  smaller.pose.joint_count -= 1;
  FrameInput wrong = actor.input(PoseProgram().external(0));
  wrong.program_inputs.externals = {&smaller, 1};
  EXPECT_EQ(copy.check_room(wrong), ErrorCode::size_mismatch);
}

TEST(cut_frame, a_frame_in_two_halves_has_the_bits_of_the_whole_and_goes_on_from_what_is_written) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Actor actor(seed, true);
    PoseProgram program;
    program.sample(0, 0.3, 0.5f).sample(1, 0.6, 0.5f).mean(2).override_joints(0);
    const FrameInput input = actor.input(program);
    FrameBuffer whole(actor.plan), halves(actor.plan);
    ASSERT_EQ(run_plan(actor.plan, input, whole), ErrorCode::ok);
    for (const std::size_t ops : {std::size_t{1}, std::size_t{3}, kMostPoseOps}) {
      CutPose pose;
      ASSERT_EQ(run_to_cut(actor.plan, input, halves, pose, ops), ErrorCode::ok);
      EXPECT_EQ(pose.model.size(), actor.scene.skeleton.joint_count());
      ASSERT_EQ(run_from_cut(actor.plan, input, halves), ErrorCode::ok);
      EXPECT_EQ(first_difference(whole.result(), halves.result()), "") << ops;
    }
    CutPose pose;
    ASSERT_EQ(run_to_cut(actor.plan, input, halves, pose, 3), ErrorCode::ok);
    for (std::size_t j = 0; j < pose.local.joint_count; ++j) pose.local.set(j, actor.external.pose.get(j));
    ASSERT_EQ(run_from_cut(actor.plan, input, halves), ErrorCode::ok);
    ASSERT_EQ(run_plan(actor.plan, actor.input(PoseProgram().external(0).override_joints(0)), whole), ErrorCode::ok);
    EXPECT_TRUE(same_bits<Affine>(whole.result().model, halves.result().model)) << "the rest of the program ran on it";
  }
}

TEST(cut_frame, matrices_that_stay_deform_nothing_and_frames_count_up) {
  const Actor actor(2, true);
  const ClipLayer layer{0, 0.3};
  const FrameInput input{.layers = {&layer, 1}, .weights = {}, .root = {}};
  FrameBuffer frame(actor.plan);
  CutPose pose;
  for (std::uint64_t number = 1; number <= 3; ++number) {
    ASSERT_EQ(run_to_cut(actor.plan, input, frame, pose), ErrorCode::ok);
    ASSERT_EQ(run_from_cut(actor.plan, input, frame), ErrorCode::ok);
    EXPECT_EQ(frame.result().frame, number);
    EXPECT_EQ(frame.result().work.vertices_skinned_linear > 0, number == 1);
  }
  // The pose in memory is the caller's, so the next whole frame does not trust it.
  ASSERT_EQ(run_to_cut(actor.plan, input, frame, pose), ErrorCode::ok);
  pose.local.plane(PoseSpan::tx)[0] += 1.0f;
  ASSERT_EQ(run_from_cut(actor.plan, input, frame), ErrorCode::ok);
  ASSERT_EQ(run_plan(actor.plan, input, frame), ErrorCode::ok);
  FrameBuffer fresh(actor.plan);
  ASSERT_EQ(run_plan(actor.plan, input, fresh), ErrorCode::ok);
  EXPECT_EQ(first_difference(frame.result(), fresh.result()), "");
}

TEST(cut_frame, halves_out_of_order_and_poses_with_nan_are_refused) {
  const Actor actor(2, true);
  const FrameInput input;
  FrameBuffer frame(actor.plan);
  CutPose pose;
  EXPECT_EQ(run_from_cut(actor.plan, input, frame), ErrorCode::no_cut);
  ASSERT_EQ(run_to_cut(actor.plan, input, frame, pose), ErrorCode::ok);
  ASSERT_EQ(run_plan(actor.plan, input, frame), ErrorCode::ok) << "a whole frame drops the cut";
  EXPECT_EQ(run_from_cut(actor.plan, input, frame), ErrorCode::no_cut);
  ASSERT_EQ(run_to_cut(actor.plan, input, frame, pose), ErrorCode::ok);
  pose.local.plane(PoseSpan::ry)[1] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(run_from_cut(actor.plan, input, frame), ErrorCode::not_finite);
  pose.local.plane(PoseSpan::ry)[1] = 0.0f;
  EXPECT_EQ(run_from_cut(actor.plan, input, frame), ErrorCode::ok);
  EXPECT_EQ(run_to_cut(actor.plan, {.layers = {}, .weights = {}, .root = {}, .asleep = true}, frame, pose),
            ErrorCode::unsupported);
  const Plan uncut = compile_plan(lend(actor.scene), Needs{});
  FrameBuffer of_uncut(uncut);
  EXPECT_EQ(run_to_cut(uncut, input, of_uncut, pose), ErrorCode::not_in_needs);
}

}  // namespace
}  // namespace sinew::test
