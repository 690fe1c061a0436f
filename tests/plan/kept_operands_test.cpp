// SPDX-License-Identifier: MIT
// Frames keep what transitions need of their operands. Their bits are those of frames that keep nothing.
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "runtime/base/same_bits.h"
#include "runtime/plan/cut_frame.h"
#include "runtime/pose/pose_memory.h"
#include "tests/plan/frame_equality.h"
#include "tests/pose_program/program_stage.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

constexpr std::uint16_t kSteps = 40;

class kept_operands : public testing::Test {
 protected:
  kept_operands() : scene_(scene_with_properties(3)), pose_(scene_.skeleton.joint_count()) {
    for (std::size_t j = 0; j < scene_.skeleton.joint_count(); ++j) pose_.span().set(j, scene_.skeleton.rest[j]);
    Needs needs{.out = {.palettes = true}};
    needs.in.program = {.ops = 40, .slots = 6, .externals = 1, .kept = 4};
    needs.in.cut = true;
    plan_ = compile_plan(lend(scene_), needs);
  }

  FrameInput input(const PoseProgram& program) {
    external_ = {pose_.span(), {}, {}, version_};
    FrameInput input;
    input.program = program.ops();
    input.program_inputs = {.externals = {&external_, 1}};
    return input;
  }

  /// Runs the frame into `frame`, and into a new one that keeps nothing.     out  the work of the first
  WorkCounters run_both(const FrameInput& input, FrameBuffer& frame) {
    FrameBuffer fresh(plan_);
    const AllocationCounter allocations;
    EXPECT_EQ(run_plan(plan_, input, frame), ErrorCode::ok) << why_refused(plan_, input, frame);
    EXPECT_EQ(allocations.count(), 0u);
    EXPECT_EQ(run_plan(plan_, input, fresh), ErrorCode::ok);
    EXPECT_EQ(first_difference(frame.result(), fresh.result()), "");
    for (std::size_t j = 0; j < frame.result().local.joint_count; ++j)
      EXPECT_TRUE(same_bits(frame.result().local.get(j), fresh.result().local.get(j))) << j;
    return frame.result().work;
  }

  Scene scene_;
  Plan plan_;
  PoseMemory pose_;
  ExternalPose external_;
  ContentVersion version_ = 1;
};

void add_inertialize(PoseProgram& program, double start_s, double progress) {
  program.sample(0, start_s).sample(0, start_s - 0.01).sample(1, 0.2).sample(1, 0.19).inertialize(progress, kSteps);
}

TEST_F(kept_operands, cost_nothing_while_a_transition_goes_on) {
  FrameBuffer frame(plan_);
  for (int i = 0; i <= 10; ++i) {
    PoseProgram program = PoseProgram().sample(1, 0.2 + 0.01 * i);
    add_inertialize(program, 0.5, i / 10.0);
    const WorkCounters work = run_both(input(program), frame);
    EXPECT_EQ(work.clips_sampled, i == 0 ? 5u : 1u) << i;
    EXPECT_EQ(work.transitions_started, i == 0 ? 1u : 0u) << i;
    EXPECT_EQ(work.poses_in_transition, i == 10 ? 0u : 1u) << "one that is over does nothing";
  }
}

TEST_F(kept_operands, are_found_again_where_another_transition_begins_or_ends) {
  FrameBuffer frame(plan_);
  std::vector<std::uint64_t> started;
  for (int i = 0; i <= 12; ++i) {
    PoseProgram program = PoseProgram().sample(1, 0.2 + 0.01 * i);
    if (i >= 4) program.sample(1, 0.3).sample(1, 0.29).dead_blend((i - 4) / 10.0, kSteps);
    if (i >= 2 && i < 8) add_inertialize(program, 0.7, (i - 2) / 10.0);
    if (i < 6) add_inertialize(program, 0.5, i / 10.0);
    started.push_back(run_both(input(program), frame).transitions_started);
  }
  EXPECT_EQ(started, (std::vector<std::uint64_t>{1, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0}));
}

// A program between updates: the later pose lies over the earlier one by the part of the way.
TEST_F(kept_operands, are_poses_between_updates_each_sampled_once) {
  Needs needs = plan_.needs();
  needs.in.between_updates = true;
  const Plan plan = compile_plan(lend(scene_), needs);
  FrameBuffer by_program(plan_), by_layers(plan);
  for (int i = 0; i < 12; ++i) {
    const double from_s = 0.1 * (i / 4), to_s = from_s + 0.1;
    const float way = 0.25f * static_cast<float>(i % 4);
    const PoseProgram program = PoseProgram().sample(0, from_s).cached().sample(0, to_s).cached(way).overlay();
    const WorkCounters work = run_both(input(program), by_program);
    EXPECT_EQ(work.clips_sampled, i == 0 ? 2u : i % 4 == 0 ? 1u : 0u) << i;
    const ClipLayer from{0, from_s}, to{0, to_s};
    FrameInput layered{.layers = {&from, 1}, .weights = {}, .root = {}};
    layered.next_layers = {&to, 1};
    layered.interpolation_factor = way;
    ASSERT_EQ(run_plan(plan, layered, by_layers), ErrorCode::ok);
    for (std::size_t j = 0; j < scene_.skeleton.joint_count(); ++j) {
      const Transform a = by_program.result().local.get(j), b = by_layers.result().local.get(j);
      EXPECT_LT(glm::distance(a.translation, b.translation), 1e-6f);
      EXPECT_GT(std::abs(quat_dot(a.rotation, b.rotation)), 1.0f - 1e-6f);
    }
  }
}

TEST_F(kept_operands, of_the_caller_stand_by_their_versions) {
  FrameBuffer frame(plan_);
  const auto started = [&](double progress) {
    const PoseProgram program =
        PoseProgram().sample(1, progress).external(0).external(0).dead_blend(progress, kSteps).sample(0, 0.1).cached();
    PoseProgram whole = program;
    whole.mean(2);
    return run_both(input(whole), frame);
  };
  EXPECT_EQ(started(0.1).transitions_started, 1u);
  EXPECT_EQ(started(0.2).transitions_started, 0u);
  pose_.span().set(0, {{1, 2, 3}});
  version_ = 2;
  EXPECT_EQ(started(0.3).transitions_started, 1u);
  version_ = 0;
  EXPECT_EQ(started(0.4).transitions_started, 1u);
  EXPECT_EQ(started(0.5).transitions_started, 1u) << "version 0 may be anything";
  EXPECT_EQ(started(0.6).clips_sampled, 1u) << "the cached sample names nothing of the caller";
}

// Three buffers take turns, as those of the job thread. Layers, sleep, cuts and given weights come in between.
TEST_F(kept_operands, have_the_bits_of_frames_that_keep_nothing_whatever_ran_before) {
  FixedRandom random(9);
  std::vector<FrameBuffer> frames;
  for (int i = 0; i < 3; ++i) frames.emplace_back(plan_);
  const std::vector<float> weights(scene_.weight_count(), 0.25f);
  const ClipLayer layer{0, 0.3};
  std::uint64_t kept = 0;
  for (int i = 0; i < 600; ++i) {
    FrameBuffer& frame = frames[random.below(3)];
    PoseProgram program = PoseProgram().sample(random.below(2), random.unit());
    if (random.below(2) == 0) program.cached();
    const std::uint32_t transitions = random.below(4);
    for (std::uint32_t t = 0; t < transitions; ++t) {
      const double start_s = 0.25 * (1 + random.below(2)), progress = 0.2 * random.below(5);
      if (random.below(2) == 0) {
        add_inertialize(program, start_s, progress);
      } else {
        random.below(3) == 0 ? program.external(0) : program.sample(0, start_s);
        program.sample(1, start_s).dead_blend(progress, kSteps);
      }
    }
    if (random.below(4) == 0) {  // in an addition, where nobody reads properties
      PoseProgram base = PoseProgram().sample(0, 0.5);
      for (const PoseOp& op : program.ops()) base.push(op);
      program = base.add_to_rest();
    }
    version_ = random.below(4);
    pose_.span().set(0, {{static_cast<float>(version_ == 0 ? i : version_), 0, 0}});
    FrameInput frame_input = input(program);
    if (random.below(6) == 0) frame_input.weights = weights;
    if (random.below(8) == 0) frame_input = {.layers = {&layer, 1}, .weights = {}, .root = {}};
    frame_input.asleep = random.below(10) == 0;
    CutPose cut;
    if (!frame_input.asleep && random.below(8) == 0) {
      ASSERT_EQ(run_to_cut(plan_, frame_input, frame, cut, 3), ErrorCode::ok);
      if (random.below(2) == 0) {
        ASSERT_EQ(run_from_cut(plan_, frame_input, frame), ErrorCode::ok);
      }
      continue;
    }
    const WorkCounters work = run_both(frame_input, frame);
    kept += work.poses_in_transition - work.transitions_started;
    ASSERT_FALSE(HasFailure()) << i;
  }
  EXPECT_GT(kept, 40u);
}

}  // namespace
}  // namespace sinew::test
