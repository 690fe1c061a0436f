// SPDX-License-Identifier: MIT
// Programs that cannot run are refused with the list, the entry and the rule, and run in no case.
#include <cstddef>
#include <cstring>
#include <limits>
#include <string>

#include "tests/c/program_actor.h"

namespace sinew::test {
namespace {

class CProgramRefusals : public ProgramActor {
 protected:
  /// Expects the refusal, and that the program as it was runs.
  template <class Break>
  void refused(sinew_error error, const std::string& line, const Break& make_bad) {
    make_lists();
    make_bad();
    EXPECT_EQ(why(), line);
    EXPECT_EQ(sinew_run(frame_, &input_), error) << line;
    make_lists();
    EXPECT_EQ(why(), "");
  }
};

const std::string kNull = sinew_describe(SINEW_NULL_ARGUMENT);

TEST_F(CProgramRefusals, lists_that_are_null) {
  refused(SINEW_NULL_ARGUMENT, "program: " + kNull, [&] { input_.program = nullptr; });
  refused(SINEW_NULL_ARGUMENT, "externals: " + kNull, [&] { inputs_.externals = nullptr; });
  refused(SINEW_NULL_ARGUMENT, "overrides: " + kNull, [&] { inputs_.overrides = nullptr; });
  refused(SINEW_NULL_ARGUMENT, "procedures: " + kNull, [&] { inputs_.procedures = nullptr; });
  refused(SINEW_NULL_ARGUMENT, "masks: " + kNull, [&] { inputs_.masks = nullptr; });
  refused(SINEW_NULL_ARGUMENT, "externals[0].pose: " + kNull, [&] { external_.pose.planes = nullptr; });
  refused(SINEW_NULL_ARGUMENT, "externals[0].weights: " + kNull, [&] { external_.weights.data = nullptr; });
  refused(SINEW_NULL_ARGUMENT, "externals[0].properties: " + kNull, [&] { external_.properties.count = 1; });
  refused(SINEW_NULL_ARGUMENT, "overrides[0].joints: " + kNull, [&] { overrides_.joints = nullptr; });
  refused(SINEW_NULL_ARGUMENT, "masks[0].joints: " + kNull, [&] { mask_.joints.data = nullptr; });
  refused(SINEW_UNSUPPORTED, "procedures[0]: it has no code to run", [&] { procedure_.run = nullptr; });
}

TEST_F(CProgramRefusals, lists_that_are_longer_than_the_needs) {
  const std::string rule = ": longer than the needs declare";
  refused(SINEW_NOT_IN_NEEDS, "externals" + rule, [&] { inputs_.external_count = 2; });
  refused(SINEW_NOT_IN_NEEDS, "overrides" + rule, [&] { inputs_.override_count = 2; });
  refused(SINEW_NOT_IN_NEEDS, "procedures" + rule, [&] { inputs_.procedure_count = 2; });
  refused(SINEW_NOT_IN_NEEDS, "masks" + rule, [&] { inputs_.mask_count = 3; });
  const sinew_joint_override two[] = {joint_, joint_};
  refused(SINEW_NOT_IN_NEEDS, "overrides: more joints than the needs declare", [&] { overrides_ = {two, 2, 1}; });
}

TEST_F(CProgramRefusals, kinds_that_do_not_exist) {
  refused(SINEW_UNSUPPORTED, "program[1]: the kind of operation is not known",
          [&] { ops_[1].kind = SINEW_OP_CACHED + 1; });
  refused(SINEW_UNSUPPORTED, "program[0]: the kind of operation is not known",
          [&] { ops_[0] = sinew_default_op(256); });
  refused(SINEW_UNSUPPORTED, "overrides[0].space: there is no such space of a joint",
          [&] { joint_.space = SINEW_OVERRIDE_WORLD + 1; });
  refused(SINEW_WRONG_STRUCT_SIZE,
          std::string("program_inputs.struct_size: ") + sinew_describe(SINEW_WRONG_STRUCT_SIZE),
          [&] { inputs_.struct_size = 3; });
}

TEST_F(CProgramRefusals, faults_of_the_runtime_are_those_of_cpp) {
  refused(SINEW_INDEX_OUT_OF_RANGE, "program[1]: there is no external pose of that index", [&] { ops_[1].index = 1; });
  refused(SINEW_INDEX_OUT_OF_RANGE, "program[1]: there is no mask of that index",
          [&] { input_.program_inputs = nullptr; });
  refused(SINEW_SIZE_MISMATCH, "program[2]: it takes more poses than those before it leave",
          [&] { ops_[2].kind = SINEW_OP_ADD; });
  refused(SINEW_NOT_A_FRACTION, "program[4]: its share lies in [0, 1]", [&] { ops_[4].time_s = 1.5; });
  refused(SINEW_SIZE_MISMATCH, "externals[0]: the pose has not one transform for each joint of poses",
          [&] { --external_.pose.joint_count; });
  refused(SINEW_SIZE_MISMATCH, "masks[0]: there is not one weight for each joint of poses",
          [&] { --mask_.joints.count; });
  refused(SINEW_SIZE_MISMATCH, "masks[0]: there is not one weight for each morph weight of the scene", [&] {
    mask_.weights = {mask_.joints.data, 1};
  });
  refused(SINEW_NOT_FINITE, "overrides[0]: a transform is not finite",
          [&] { joint_.transform.rotation.w = std::numeric_limits<float>::infinity(); });
  const sinew_layer layer{0.5, 0, SINEW_NONE, 1.0f, 0};
  refused(SINEW_UNSUPPORTED, "program: layers are given as well", [&] {
    input_.layers = &layer;
    input_.layer_count = 1;
  });
}

TEST_F(CProgramRefusals, poses_that_are_not_aligned) {
  refused(SINEW_SIZE_MISMATCH, std::string("externals[0].pose: ") + sinew_describe(SINEW_SIZE_MISMATCH),
          [&] { ++external_.pose.planes; });
}

TEST_F(CProgramRefusals, programs_that_the_needs_do_not_declare) {
  sinew_plan* plan = nullptr;
  sinew_frame* frame = nullptr;
  sinew_messages* messages = nullptr;
  ASSERT_EQ(sinew_plan_create(&scene_, nullptr, &plan), SINEW_OK);
  ASSERT_EQ(sinew_frame_create(plan, nullptr, &frame), SINEW_OK);
  EXPECT_EQ(sinew_run(frame, &input_), SINEW_NOT_IN_NEEDS);
  ASSERT_EQ(sinew_why_refused(frame, &input_, &messages), SINEW_OK);
  EXPECT_STREQ(sinew_message(messages, 0), "program: the needs declare no programs");
  input_.op_count = 0;
  EXPECT_EQ(sinew_run(frame, &input_), SINEW_NOT_IN_NEEDS) << "layers may name masks";
  inputs_.mask_count = 0;
  EXPECT_EQ(sinew_run(frame, &input_), SINEW_OK) << "no other list is looked at without a program";
  sinew_messages_destroy(messages);
  sinew_frame_destroy(frame);
  sinew_plan_destroy(plan);
}

/// Structs that end where programs begin, with a memory behind them that no version has.
template <class T, std::size_t Bytes>
struct Older {
  explicit Older(const T& known) {
    std::memset(bytes, 0xa5, sizeof(bytes));
    std::memcpy(bytes, &known, Bytes);
    get()->struct_size = Bytes;
  }
  T* get() noexcept { return reinterpret_cast<T*>(bytes); }

  alignas(T) unsigned char bytes[Bytes + 64];
};

TEST_F(CProgramRefusals, callers_from_before_programs_have_none) {
  Older<sinew_needs, offsetof(sinew_needs, program)> needs(needs_of_c());
  sinew_plan* plan = nullptr;
  ASSERT_EQ(sinew_plan_create(&scene_, needs.get(), &plan), SINEW_OK);
  Older<sinew_frame_input, offsetof(sinew_frame_input, program)> input(sinew_default_input());
  sinew_frame* frame = nullptr;
  ASSERT_EQ(sinew_frame_create(plan, nullptr, &frame), SINEW_OK);
  EXPECT_EQ(sinew_run(frame, input.get()), SINEW_OK);
  EXPECT_EQ(sinew_run(frame, &input_), SINEW_NOT_IN_NEEDS) << "the plan has no room for programs";
  Older<sinew_result_info, offsetof(sinew_result_info, local)> info(sinew_result_info{});
  ASSERT_EQ(sinew_get_result(sinew_frame_result(frame), info.get()), SINEW_OK);
  EXPECT_EQ(info.get()->model.count, joints());
  EXPECT_EQ(info.bytes[offsetof(sinew_result_info, local)], 0xa5) << "it is not written beyond its end";
  sinew_frame_destroy(frame);
  sinew_plan_destroy(plan);
}

}  // namespace
}  // namespace sinew::test
