// SPDX-License-Identifier: MIT
#include "runtime/procedures/springs/springs_procedure.h"

#include <gtest/gtest.h>

#include "runtime/plan/run_plan.h"
#include "tests/springs/spring_stage.h"
#include "tests/support/allocation_counter.h"

namespace sinew {
namespace {

/// A character whose frames are: the rest pose, then springs.
class Actor {
 public:
  Actor() {
    state_.resize(springs_.state_bytes() / 8);
    scratch_.resize(springs_.scratch_bytes() / 8);
    context.springs = &springs_;
    context.state = std::as_writable_bytes(std::span(state_));
    context.scratch = std::as_writable_bytes(std::span(scratch_));
    context.dt_s = 1.0 / 60.0;
  }

  SpringsContext context;

  const FrameResult& run() {
    const PoseProcedure procedure = springs_procedure(context);
    FrameInput input;
    input.root = affine_cast<float>(context.root);
    input.program = program_.ops();
    input.program_inputs.procedures = {&procedure, 1};
    const test::AllocationCounter counter;
    EXPECT_EQ(run_plan(plan_, input, frame_), ErrorCode::ok);
    EXPECT_EQ(counter.count(), 0u);
    return frame_.result();
  }

 private:
  Plan make_plan() {
    scene_.skeleton = chain_.skeleton;
    program_.rest().procedure(0);
    Needs needs;
    needs.in.program = room_of(program_.ops());
    return compile_plan(lend(scene_), needs);
  }

  test::HangingChain chain_;
  Springs springs_ = compile_springs(chain_.skeleton, chain_.setup).value();
  Scene scene_;
  PoseProgram program_;
  Plan plan_ = make_plan();
  FrameBuffer frame_{plan_};
  std::vector<std::uint64_t> state_, scratch_;
};

TEST(springs_procedure, swings_in_the_frames_of_a_character) {
  Actor actor;
  actor.run();
  actor.context.root.row[0].w = 0.5;
  const FrameResult& frame = actor.run();
  EXPECT_EQ(actor.context.code, ErrorCode::ok);
  EXPECT_EQ(actor.context.counts.ticks, 1u);
  EXPECT_LT(frame.model[5].row[0].w, 0.4f) << "the end stays behind";
}

TEST(springs_procedure, asleep_a_frame_runs_nothing_and_wakes_with_the_root) {
  Actor actor;
  actor.context.root.row[0].w = 0.1;
  int frames = 0;
  while (!actor.context.counts.asleep && ++frames < 2000) actor.run();
  ASSERT_LT(frames, 2000);
  actor.run();  // takes over the version of the sleep
  actor.context.counts.ticks = 99;
  const std::uint64_t since = actor.run().since_frame;
  const FrameResult& still = actor.run();
  EXPECT_EQ(actor.context.counts.ticks, 99u) << "the procedure did not run";
  EXPECT_EQ(still.since_frame, since);
  EXPECT_EQ(still.work.procedures_run, 0u);
  EXPECT_EQ(still.work.joints_composed, 0u);
  actor.context.root.row[0].w = 0.2;
  actor.run();
  EXPECT_EQ(actor.context.counts.ticks, 1u);
  EXPECT_FALSE(actor.context.counts.asleep);
}

}  // namespace
}  // namespace sinew
