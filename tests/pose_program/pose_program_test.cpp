// SPDX-License-Identifier: MIT
#include "runtime/pose_program/pose_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace sinew {
namespace {

constexpr PoseProgramLimits kLimits{
    .clips = 2, .externals = 1, .masks = 1, .overrides = 1, .mirror = false, .slots = 3};

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
      {of().sample(0, 0.0, 1.0f, 1), ErrorCode::index_out_of_range, "operation 0 (sample): there is no mask"},
      {of().sample_mirrored(0, 0.0), ErrorCode::not_in_needs, "operation 0 (sample_mirrored): nothing says how"},
      {of().external(1), ErrorCode::index_out_of_range, "operation 0 (external): there is no external pose"},
      {of().rest().override_joints(1), ErrorCode::index_out_of_range, "operation 1 (override_joints): there is no"},
      {of().rest().override_joints(0, 1.5), ErrorCode::not_a_fraction, "operation 1 (override_joints): its share"},
      {of().rest().mean(1, 1.0f, 0.0), ErrorCode::not_a_fraction, "operation 1 (mean): the threshold"},
      {of().rest().procedure(0), ErrorCode::index_out_of_range, "operation 1 (procedure): there is no procedure"},
      {of().rest().mean(2), ErrorCode::size_mismatch, "operation 1 (mean): it takes more poses"},
      {of().rest().overlay(), ErrorCode::size_mismatch, "operation 1 (overlay): it takes more poses"},
      {of().rest().rest().add(), ErrorCode::size_mismatch, "operation 2 (add): it takes more poses"},
      {of().rest().rest().rest().rest().mean(4), ErrorCode::size_mismatch, "operation 3 (rest): the memory has room"},
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
