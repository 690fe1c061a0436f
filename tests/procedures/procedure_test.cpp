// SPDX-License-Identifier: MIT
#include "runtime/procedures/procedure.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "runtime/model/scene.h"
#include "runtime/plan/run_plan.h"
#include "runtime/pose_program/pose_program.h"
#include "tests/procedures/chains.h"
#include "tests/procedures/limbs.h"

namespace sinew::test {
namespace {

using V = Vec3<double>;

/// A scene of one arm: chest, shoulder, elbow, hand.
Scene arm_scene() {
  Scene scene;
  scene.skeleton = chain_skeleton(4);
  scene.skeleton.rest[0].translation = {0, 1, 0};
  scene.skeleton.rest[2].translation = {0, -0.5f, 0.02f};
  scene.skeleton.rest[3].translation = {0, -0.5f, -0.02f};
  finish_scene(scene);
  return scene;
}

TwoBoneIk arm_ik(const V& target) {
  TwoBoneIk ik;
  ik.goal.root = 1;
  ik.goal.middle = 2;
  ik.goal.tip = 3;
  ik.goal.target = target;
  return ik;
}

struct ArmPlan {
  Plan plan;
  FrameBuffer frame;

  ArmPlan() : plan(made()), frame(plan) {}
  static Plan made() {
    Needs needs;
    needs.in.program = {.ops = 2, .slots = 1, .procedures = 1};
    return compile_plan(arm_scene(), needs);
  }
  const FrameResult& run(const PoseProcedure& procedure, double share = 1.0) {
    PoseProgram program;
    program.rest().procedure(0, share);
    FrameInput input;
    input.program = program.ops();
    input.program_inputs.procedures = {&procedure, 1};
    EXPECT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
    return frame.result();
  }
  V hand() { return V(translation_of(frame.result().model[3])); }
};

TEST(ik_procedure, runs_in_a_plan_and_an_unchanged_goal_runs_nothing_again) {
  ArmPlan arm;
  TwoBoneIk ik = arm_ik({0.1, 0.4, 0.2});
  arm.run(as_procedure(ik));
  EXPECT_EQ(ik.result.status, IkStatus::reached);
  EXPECT_LT(distance(arm.hand(), ik.goal.target), 1e-6);
  ik.result.status = IkStatus::idle;
  arm.run(as_procedure(ik));
  EXPECT_EQ(ik.result.status, IkStatus::idle) << "it did not run";
  EXPECT_LT(distance(arm.hand(), ik.goal.target), 1e-6);
  ik.goal.target.x += 1e-6;
  arm.run(as_procedure(ik));
  EXPECT_EQ(ik.result.status, IkStatus::reached) << "the goal changed";
}

TEST(ik_procedure, the_share_of_the_operation_multiplies_the_weight) {
  ArmPlan arm;
  TwoBoneIk ik = arm_ik({0.1, 0.4, 0.2});
  ik.goal.blend = IkBlend::effector;
  arm.run(as_procedure(ik), 0.5);
  EXPECT_TRUE(is_near(arm.hand(), V(0.05, 0.2, 0.1), 1e-6)) << "the hand rests at the origin";
  EXPECT_EQ(ik.result.status, IkStatus::limited);
}

TEST(ik_procedure, a_refused_goal_says_why_and_keeps_the_pose) {
  ArmPlan arm;
  TwoBoneIk ik = arm_ik({0, 0, 0});
  ik.goal.tip = 7;
  arm.run(as_procedure(ik));
  EXPECT_EQ(ik.result.error, ErrorCode::index_out_of_range);
  EXPECT_EQ(arm.hand(), V(0, 0, 0));
}

TEST(ik_procedure, a_list_runs_in_order) {
  ArmPlan arm;
  TwoBoneIk first = arm_ik({0.1, 0.4, 0.2}), second = arm_ik({-0.2, 0.5, 0.1});
  const std::array both{as_procedure(first), as_procedure(second)};
  ProcedureList list{both};
  arm.run(as_procedure(list));
  EXPECT_EQ(first.result.status, IkStatus::reached);
  EXPECT_LT(distance(arm.hand(), second.goal.target), 1e-6);
  EXPECT_NE(as_procedure(list).version, 0u);
  const std::array unknown{as_procedure(first), PoseProcedure{both[1].run, both[1].context, 0}};
  ProcedureList other{unknown};
  EXPECT_EQ(as_procedure(other).version, 0u);
}

TEST(ik_procedure, aims_and_chains_are_operations_too) {
  ArmPlan arm;
  const std::array joints{AimJoint{.joint = 1}};
  AimIk aim;
  aim.goal.joints = joints;
  aim.goal.target = {3, 2, 1};
  arm.run(as_procedure(aim));
  EXPECT_EQ(aim.result.status, IkStatus::reached);

  const std::array chain{ChainIkJoint{.joint = 1}, ChainIkJoint{.joint = 2}};
  const std::array effectors{ChainEffector{.joint = 3, .target = {0.2, 0.5, 0.3}}};
  alignas(64) static std::byte memory[1 << 14];
  ChainIk ik;
  ik.goal.joints = chain;
  ik.goal.effectors = effectors;
  ik.goal.iterations = 60;
  ik.memory = memory;
  arm.run(as_procedure(ik));
  EXPECT_EQ(ik.result.status, IkStatus::reached) << ik.result.metres_left;
  EXPECT_LT(distance(arm.hand(), effectors[0].target), 1.1e-4);
  ik.memory = {};
  ik.goal.weight = 0.5f;
  arm.run(as_procedure(ik));
  EXPECT_EQ(ik.result.error, ErrorCode::size_mismatch);
}

TEST(ik_procedure, every_field_of_a_goal_counts_in_its_version) {
  std::set<ContentVersion> versions;
  const auto two_bones = [&](auto change) {
    TwoBoneIk ik = arm_ik({0, 0, 0});
    change(ik.goal);
    EXPECT_TRUE(versions.insert(as_procedure(ik).version).second);
  };
  two_bones([](auto&) {});
  two_bones([](auto& goal) { goal.root = 0; });
  two_bones([](auto& goal) { goal.target.z = 1; });
  two_bones([](auto& goal) { goal.pole.x = 1; });
  two_bones([](auto& goal) { goal.pole_kind = PoleKind::point; });
  two_bones([](auto& goal) { goal.blend = IkBlend::effector; });
  two_bones([](auto& goal) { goal.end = EndRotation::keep; });
  two_bones([](auto& goal) { goal.end_rotation.x = 1; });
  two_bones([](auto& goal) { goal.middle_axis.y = 1; });
  two_bones([](auto& goal) { goal.twist_rad = 1; });
  two_bones([](auto& goal) { goal.weight = 0.5f; });
  two_bones([](auto& goal) { goal.soft_reach = 0.5f; });
  two_bones([](auto& goal) { goal.most_stretch = 2; });
  two_bones([](auto& goal) { goal.least_bend_rad = 1; });
  two_bones([](auto& goal) { goal.most_bend_rad = 1; });
  two_bones([](auto& goal) { goal.pole_fade = 0; });
  two_bones([](auto& goal) { goal.tolerance = 0; });
  std::array joints{ChainIkJoint{.joint = 1}};
  std::array effectors{ChainEffector{.joint = 3}};
  std::array limits{JointLimit{}};
  ChainIk chain;
  chain.goal.joints = joints;
  chain.goal.effectors = effectors;
  chain.goal.limits = limits;
  EXPECT_TRUE(versions.insert(as_procedure(chain).version).second);
  joints[0].moves = true;
  EXPECT_TRUE(versions.insert(as_procedure(chain).version).second);
  effectors[0].rotation_weight = 1;
  EXPECT_TRUE(versions.insert(as_procedure(chain).version).second);
  limits[0].swing_z_rad = 1;
  EXPECT_TRUE(versions.insert(as_procedure(chain).version).second);
  chain.goal.solver = ChainSolver::damped;
  EXPECT_TRUE(versions.insert(as_procedure(chain).version).second);
}

}  // namespace
}  // namespace sinew::test
