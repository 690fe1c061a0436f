// SPDX-License-Identifier: MIT
#include "runtime/pose_program/pose_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace sinew {
namespace {

constexpr PoseProgramLimits kLimits{
    .clips = 2, .externals = 1, .masks = 1, .overrides = 1, .mirror = false, .slots = 3, .kept = 1};

TEST(pose_program, a_sound_program_has_no_fault_and_says_how_many_poses_it_needs) {
  PoseProgram program;
  program.sample(0, 0.1).sample(1, 0.2, 0.5f, 0).mean(2).external(0).overlay().override_joints(0);
  EXPECT_EQ(find_fault(program.ops(), kLimits).code, ErrorCode::ok);
  EXPECT_EQ(pose_slots(program.ops()), 2u);
  program.clear();
  program.rest().sample(0, 0.1).rest().add();
  EXPECT_EQ(pose_slots(program.ops()), 3u);
  EXPECT_EQ(check(program.ops(), kLimits), ErrorCode::ok);
}

struct Misuse {
  PoseProgram program;
  ErrorCode code;
  const char* sentence;
};

TEST(pose_program, a_fault_names_its_operation_and_its_rule) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const auto of = [] { return PoseProgram(); };
  const Misuse misuses[] = {
      {of(), ErrorCode::size_mismatch, "program: exactly one pose remains"},
      {of().rest().rest(), ErrorCode::size_mismatch, "program: exactly one pose remains"},
      {of().sample(2, 0.0), ErrorCode::index_out_of_range, "operation 0 (sample): there is no clip"},
      {of().sample(70000, 0.0), ErrorCode::index_out_of_range, "operation 0 (sample): there is no clip"},
      {of().rest().sample(0, nan), ErrorCode::not_finite, "operation 1 (sample): its time"},
      {of().sample(0, 0.0, infinity), ErrorCode::not_finite, "operation 0 (sample): its weight is not finite"},
      {of().sample(0, 0.0, -0.5f), ErrorCode::negative_weight, "operation 0 (sample): its weight is negative"},
      {of().rest(-1.0f).rest().add_to_rest(), ErrorCode::negative_weight, "operation 0 (rest): its weight is negative"},
      {of().rest().rest().rest(-1.0f).add(), ErrorCode::negative_weight, "operation 2 (rest): its weight is negative"},
      {of().rest().rest(-1.0f).overlay(), ErrorCode::negative_weight, "operation 1 (rest): its weight is negative"},
      {of().rest().rest(-1.0f).mean(2), ErrorCode::negative_weight, "operation 1 (rest): its weight is negative"},
      {of().sample(0, 0.0, 1.0f, 1), ErrorCode::index_out_of_range, "operation 0 (sample): there is no mask"},
      {of().sample_mirrored(0, 0.0), ErrorCode::not_in_needs, "operation 0 (sample_mirrored): nothing says how"},
      {of().external(1), ErrorCode::index_out_of_range, "operation 0 (external): there is no external pose"},
      {of().rest().override_joints(1), ErrorCode::index_out_of_range, "operation 1 (override_joints): there is no"},
      {of().rest().override_joints(0, 1.5), ErrorCode::not_a_fraction, "operation 1 (override_joints): its share"},
      {of().rest().mean(1, 1.0f, 0.0), ErrorCode::not_a_fraction, "operation 1 (mean): the threshold"},
      {of().rest().procedure(0), ErrorCode::index_out_of_range, "operation 1 (procedure): there is no procedure"},
      {of().rest().mean(2), ErrorCode::size_mismatch, "operation 1 (mean): it takes more poses"},
      {of().rest().overlay(), ErrorCode::size_mismatch, "operation 1 (overlay): it takes more poses"},
      {of().rest().rest().add_to_rest(1.0f, static_cast<DeltaFrame>(2)), ErrorCode::unsupported,
       "operation 2 (add_to_rest): an addition is in the parent's frame"},
      {of().rest().rest().add(), ErrorCode::size_mismatch, "operation 2 (add): it takes more poses"},
      {of().rest().rest().rest().rest().mean(4), ErrorCode::size_mismatch, "operation 3 (rest): the memory has room"},
      {of().rest().rest().rest().dead_blend(1.5, 9), ErrorCode::not_a_fraction,
       "operation 3 (dead_blend): the progress"},
      {of().rest().rest().rest().dead_blend(-0.5, 9), ErrorCode::not_a_fraction,
       "operation 3 (dead_blend): the progress"},
      {of().rest().rest().rest().dead_blend(0.5, 0), ErrorCode::not_a_fraction,
       "operation 3 (dead_blend): a transition"},
      {of().rest().rest().dead_blend(0.5, 9), ErrorCode::size_mismatch, "operation 2 (dead_blend): it takes more"},
      {of().rest().rest().rest().inertialize(0.5, 9), ErrorCode::size_mismatch, "operation 3 (inertialize): it takes"},
      {of().cached(), ErrorCode::size_mismatch, "operation 0 (cached): it takes more poses"},
      {of().rest().cached().cached(), ErrorCode::not_in_needs, "operation 2 (cached): the memory has room for fewer"},
      {of().push({.kind = static_cast<PoseOpKind>(99)}), ErrorCode::unsupported, "operation 0 (kind 99)"},
  };
  for (const Misuse& misuse : misuses) {
    const PoseProgramFault fault = find_fault(misuse.program.ops(), kLimits);
    EXPECT_EQ(fault.code, misuse.code) << misuse.sentence;
    EXPECT_EQ(check(misuse.program.ops(), kLimits), misuse.code) << misuse.sentence;
    EXPECT_THAT(describe(fault, misuse.program.ops()), testing::StartsWith(misuse.sentence));
  }
}

TEST(pose_program, the_room_of_a_program_reaches_to_its_largest_indices) {
  PoseProgram program;
  program.sample(0, 0.1, 1.0f, 4).external(2).mean(2).rest().overlay_model().override_joints(1).procedure(3);
  const PoseProgramRoom room = room_of(program.ops());
  EXPECT_EQ(room, (PoseProgramRoom{.ops = 7,
                                   .slots = 2,
                                   .externals = 3,
                                   .overrides = 2,
                                   .masks = 5,
                                   .procedures = 4,
                                   .overlays_in_model_space = true}));
  const PoseProgramRoom other{.ops = 3, .slots = 9, .overridden_joints = 5};
  EXPECT_EQ(larger(room, other), larger(other, room));
  EXPECT_EQ(larger(room, other).slots, 9u);
  EXPECT_EQ(larger(room, other).procedures, 4u);
  PoseProgramLimits limits{.externals = 3, .masks = 5, .overrides = 2, .procedures = 4, .slots = 2};
  limits.clips = 1;
  EXPECT_EQ(check(program.ops(), limits), ErrorCode::ok);
  limits.overlays_in_model_space = false;
  EXPECT_EQ(check(program.ops(), limits), ErrorCode::not_in_needs);
}

TEST(pose_program, indices_and_shares_are_taken_up_to_their_limits_and_not_beyond) {
  const auto code = [](const PoseProgram& program) { return check(program.ops(), kLimits); };
  const auto beyond = ErrorCode::index_out_of_range;
  EXPECT_EQ(code(PoseProgram().sample(1, 0.0, 1.0f, 0)), ErrorCode::ok) << "the last clip, the last mask";
  EXPECT_EQ(code(PoseProgram().sample(2, 0.0)), beyond);
  EXPECT_EQ(code(PoseProgram().sample(0, 0.0, 1.0f, 254)), beyond) << "the number before that of no mask";
  EXPECT_EQ(code(PoseProgram().external(0)), ErrorCode::ok);
  EXPECT_EQ(code(PoseProgram().external(1)), beyond);
  EXPECT_EQ(code(PoseProgram().rest(0.0f)), ErrorCode::ok);
  EXPECT_EQ(code(PoseProgram().rest(-1e-30f)), ErrorCode::negative_weight);
  EXPECT_EQ(code(PoseProgram().rest().rest(-1.0f).add_to_rest()), ErrorCode::ok) << "a layer may subtract";
  EXPECT_EQ(code(PoseProgram().rest().rest(-1.0f).rest().cached().add()), ErrorCode::ok);
  const double above_1 = std::nextafter(1.0, 2.0);
  for (const double share : {0.0, 1.0}) EXPECT_EQ(code(PoseProgram().rest().override_joints(0, share)), ErrorCode::ok);
  for (const double share : {-1e-300, above_1})
    EXPECT_EQ(code(PoseProgram().rest().override_joints(0, share)), ErrorCode::not_a_fraction) << share;
  for (const double threshold : {1e-300, 1.0})
    EXPECT_EQ(code(PoseProgram().rest().mean(1, 1.0f, threshold)), ErrorCode::ok) << threshold;
  for (const double threshold : {0.0, above_1})
    EXPECT_EQ(code(PoseProgram().rest().mean(1, 1.0f, threshold)), ErrorCode::not_a_fraction) << threshold;
  PoseProgramLimits limits = kLimits;
  limits.slots = 2;
  EXPECT_EQ(check(PoseProgram().rest().rest().overlay().ops(), limits), ErrorCode::ok);
  EXPECT_EQ(check(PoseProgram().rest().rest().rest().mean(3).ops(), limits), ErrorCode::size_mismatch);
}

TEST(pose_program, both_operations_that_mirror_need_a_mirror) {
  const PoseOp rest{.kind = PoseOpKind::rest_mirrored}, sample{.kind = PoseOpKind::sample_mirrored};
  for (const PoseOp& op : {rest, sample})
    for (const bool there : {false, true}) {
      PoseProgramLimits limits = kLimits;
      limits.mirror = there;
      EXPECT_EQ(check({&op, 1}, limits), there ? ErrorCode::ok : ErrorCode::not_in_needs);
    }
}

TEST(pose_program, the_room_of_transitions_and_cached_poses_is_their_number) {
  PoseProgram program = PoseProgram().rest().cached().rest().rest().dead_blend(0.5, 9);
  program.rest().rest().rest().rest().inertialize(0.5, 9);
  EXPECT_EQ(room_of(program.ops()).kept, 3u);
  EXPECT_EQ(pose_slots(program.ops()), 5u) << "one transition may follow another without more room";
  EXPECT_EQ(larger({.kept = 2}, {.kept = 3}).kept, 3u);
}

TEST(pose_program, more_than_255_operations_are_counted_and_refused) {
  PoseProgram program;
  for (int i = 0; i < 255; ++i) program.rest();
  EXPECT_TRUE(program.is_complete());
  EXPECT_FALSE(program.rest().is_complete());
  EXPECT_EQ(program.ops().size(), 255u);
  const std::vector<PoseOp> long_program(256);
  EXPECT_THAT(describe(find_fault(long_program, kLimits), long_program), testing::HasSubstr("at most 255"));
}

}  // namespace
}  // namespace sinew
