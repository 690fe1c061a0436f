// SPDX-License-Identifier: MIT
#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "runtime/base/same_bits.h"
#include "runtime/c/handles.h"
#include "runtime/plan/cut_frame.h"
#include "runtime/pose/pose_memory.h"
#include "runtime/sinew.h"
#include "tests/c/engine.h"
#include "tests/c/engine_program.h"
#include "tests/c/numbers.h"
#include "tests/scenes/random_scene.h"

namespace sinew::test {

/// Appends the planes of a pose, without what lies behind the last joint.
inline void add_pose(std::vector<float>& to, const sinew_pose& pose) {
  for (std::uint32_t j = 0; j < pose.joint_count; ++j) {
    sinew_transform transform;
    EXPECT_EQ(sinew_pose_get(&pose, j, &transform), SINEW_OK);
    add_numbers(to, std::span<const sinew_transform>(&transform, 1));
  }
}

/// All numbers of a result, and its local pose.
inline std::vector<float> all_numbers_of(const sinew_result* result) {
  Numbers numbers;
  sinew_result_info info{.struct_size = sizeof(info)};
  EXPECT_EQ(engine_read(result, 2, &numbers), SINEW_OK);
  EXPECT_EQ(sinew_get_result(result, &info), SINEW_OK);
  std::vector<float> all = numbers.all();
  add_pose(all, info.local);
  return all;
}

/// One scene with a plan and a frame in C and in C++, and one program in both with a pose, a joint, a procedure and a
/// mask of the caller.
class ProgramActor : public testing::Test {
 protected:
  ProgramActor()
      : scene_{random_scene(3)}, pose_memory_(joints()), mask_of_needs_(joints(), 0.5f), mask_weights_(joints(), 1.0f) {
    make_lists();
    const sinew_needs needs = needs_of_c();
    EXPECT_EQ(sinew_plan_create(&scene_, &needs, &plan_), SINEW_OK);
    EXPECT_EQ(sinew_frame_create(plan_, nullptr, &frame_), SINEW_OK);
  }
  ~ProgramActor() override {
    sinew_frame_destroy(frame_);
    sinew_plan_destroy(plan_);
  }

  std::size_t joints() const { return scene_.scene.skeleton.joint_count(); }

  void make_lists() {
    input_ = sinew_default_input();
    EXPECT_EQ(sinew_pose_sample(&scene_, 1, 0.4, &pose_), SINEW_OK);
    for (std::size_t j = 0; j < joints(); j += 2) mask_weights_[j] = 0.25f;
    weights_.assign(scene_.scene.weight_count(), 0.5f);
    engine_write_program(0.3, 1, ops_);
    external_ = {pose_, {weights_.data(), weights_.size()}, {nullptr, 0}, 1};
    joint_ = {static_cast<std::uint32_t>(joints() - 1),
              {{0.5f, 1.0f, -2.0f}, {0.6f, 0.0f, 0.0f, 0.8f}, {1.0f, 1.0f, 1.0f}},
              SINEW_OVERRIDE_LOCAL};
    overrides_ = {&joint_, 1, 1};
    procedure_ = {engine_lift, &height_, 1};
    mask_ = {{mask_weights_.data(), mask_weights_.size()}, {weights_.data(), weights_.size()}, {}, 1};
    inputs_ = {sizeof(inputs_), &external_, 1, &overrides_, 1, &procedure_, 1, &mask_, 1, nullptr};
    input_.program = ops_;
    input_.op_count = engine_program_ops;
    input_.program_inputs = &inputs_;
    room_.struct_size = sizeof(room_);
    EXPECT_EQ(sinew_program_room_of(ops_, engine_program_ops, &room_), SINEW_OK);
    room_.overridden_joints = 1;
  }

  /// Views of `room_` and `mask_of_needs_`.
  sinew_needs needs_of_c() const {
    sinew_needs needs = sinew_default_needs();
    needs.flags |= SINEW_NEED_BOUNDS | SINEW_NEED_PALETTES | SINEW_NEED_CUT;
    needs.masks = mask_of_needs_.data();
    needs.mask_count = 1;
    needs.program = &room_;
    return needs;
  }

  /// The same program and lists for C++, without C's types.
  struct OfCpp {
    static void lift(void* context, const ProcedurePose& pose) {
      pose.local.plane(PoseSpan::ty)[1] += *static_cast<const float*>(context) * pose.share;
      for (float& weight : pose.weights) weight *= 0.5f;
    }

    explicit OfCpp(ProgramActor& of)
        : external{{of.pose_.planes, of.joints(), PoseSpan::stride_for(of.joints())}, of.weights_, {}, 1},
          joint{of.joint_.joint,
                {{0.5f, 1.0f, -2.0f}, quat_xyzw(0.6f, 0.0f, 0.0f, 0.8f), {1.0f, 1.0f, 1.0f}},
                static_cast<OverrideSpace>(of.joint_.space)},
          overrides{{&joint, 1}, 1},
          procedure{&lift, &of.height_, 1},
          mask{.joints = of.mask_weights_, .weights = of.weights_, .version = 1} {
      program.sample(0, 0.3).external(0, 0.5f, 1).overlay().override_joints(0).procedure(0, 0.75);
      Needs needs{.out = {.palettes = true, .bounds = true}};
      needs.in.masks = {of.mask_of_needs_};
      needs.in.program = room_of(program.ops());
      needs.in.program.overridden_joints = 1;
      needs.in.cut = true;
      plan = compile_plan(lend(of.scene_.scene), needs);
      input.program = program.ops();
      input.program_inputs = {{&external, 1}, {&overrides, 1}, {&procedure, 1}, {&mask, 1}};
    }

    ExternalPose external;
    JointOverride joint;
    JointOverrides overrides;
    PoseProcedure procedure;
    PoseMask mask;
    PoseProgram program;
    Plan plan;
    FrameInput input;
  };

  std::vector<float> numbers_by_cpp() {
    const OfCpp cpp(*this);
    FrameBuffer frame(cpp.plan);
    EXPECT_EQ(run_plan(cpp.plan, cpp.input, frame), ErrorCode::ok) << why_refused(cpp.plan, cpp.input, frame);
    return all_numbers_of(reinterpret_cast<const sinew_result*>(&frame.result()));
  }

  /// The line of sinew_why_refused; empty where there is none.
  std::string why() {
    sinew_messages* messages = nullptr;
    EXPECT_EQ(sinew_why_refused(frame_, &input_, &messages), SINEW_OK);
    const std::string line = sinew_message(messages, 0);
    sinew_messages_destroy(messages);
    return line;
  }

  sinew_scene scene_;
  PoseMemory pose_memory_;
  sinew_pose pose_{pose_memory_.span().planes, joints()};
  std::vector<float> mask_of_needs_, mask_weights_, weights_;
  float height_ = 2.0f;
  sinew_pose_op ops_[engine_program_ops];
  sinew_external_pose external_;
  sinew_joint_override joint_;
  sinew_joint_overrides overrides_;
  sinew_pose_procedure procedure_;
  sinew_pose_mask mask_;
  sinew_program_inputs inputs_;
  sinew_program_room room_{};
  sinew_frame_input input_;
  sinew_plan* plan_ = nullptr;
  sinew_frame* frame_ = nullptr;
};

}  // namespace sinew::test
