// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "runtime/c/handles.h"
#include "runtime/procedures/two_bone_ik.h"
#include "runtime/sinew.h"
#include "tests/procedures/posed.h"

namespace sinew::test {
namespace {

/// Chest, shoulder, elbow, hand: a straight arm that hangs down, a little bent at rest.
struct CIk : testing::Test {
  sinew_scene scene{made()};
  PoseBuffer pose{4};
  sinew_pose local{pose.span().planes, 4};
  std::unique_ptr<sinew_ik, void (*)(sinew_ik*)> ik{nullptr, sinew_ik_destroy};

  CIk() {
    sinew_pose_rest(&scene, &local);
    sinew_ik* made = nullptr;
    EXPECT_EQ(sinew_ik_create(&scene, &made), SINEW_OK);
    ik.reset(made);
  }
  static Scene made() {
    Scene scene;
    scene.skeleton = chain_skeleton(4);
    scene.skeleton.rest[0].translation = {0, 1, 0};
    scene.skeleton.rest[2].translation = {0, -0.5f, 0.02f};
    scene.skeleton.rest[3].translation = {0, -0.5f, -0.02f};
    finish_scene(scene);
    return scene;
  }
  sinew_point hand() const {
    sinew_affine model[4];
    EXPECT_EQ(sinew_pose_to_model(&scene, &local, nullptr, model, 4), SINEW_OK);
    const auto& row = model[3].row;
    return {static_cast<double>(row[0][3]), static_cast<double>(row[1][3]), static_cast<double>(row[2][3])};
  }
  sinew_ik_result result() const {
    sinew_ik_result out{.struct_size = sizeof(out)};
    EXPECT_EQ(sinew_get_ik_result(ik.get(), &out), SINEW_OK);
    return out;
  }
  static sinew_two_bone_goal arm_goal() {
    sinew_two_bone_goal goal = sinew_default_two_bone_goal();
    goal.root = 1;
    goal.middle = 2;
    goal.tip = 3;
    goal.target = {0.1, 0.4, 0.2};
    return goal;
  }
  void expect_hand(const sinew_point& at, double tolerance) const {
    const sinew_point is = hand();
    EXPECT_LT(std::hypot(is.x - at.x, is.y - at.y, is.z - at.z), tolerance);
  }
};

TEST_F(CIk, an_arm_reaches_its_target) {
  const sinew_two_bone_goal goal = arm_goal();
  ASSERT_EQ(sinew_ik_set_two_bone(ik.get(), &goal), SINEW_OK);
  ASSERT_EQ(sinew_ik_solve(ik.get(), &local), SINEW_OK);
  EXPECT_EQ(result().status, static_cast<std::uint32_t>(SINEW_IK_REACHED));
  expect_hand(goal.target, 1e-6);
}

TEST_F(CIk, a_joint_aims_within_its_limit) {
  const sinew_aim_joint joints[] = {{.joint = 1, .share = 1.0f, .limit = SINEW_NONE}};
  sinew_aim_goal goal = sinew_default_aim_goal();
  goal.joints = joints;
  goal.joint_count = 1;
  goal.target = {5, 1, 0};
  ASSERT_EQ(sinew_ik_set_aim(ik.get(), &goal), SINEW_OK);
  ASSERT_EQ(sinew_ik_solve(ik.get(), &local), SINEW_OK);
  EXPECT_EQ(result().status, static_cast<std::uint32_t>(SINEW_IK_REACHED));

  const sinew_joint_limit limit{{0, 0, 0, 1}, {0, 0, 0, 1}, 0.2f, 0.2f, -0.1f, 0.1f, 1, 1};
  const sinew_aim_joint limited[] = {{.joint = 1, .share = 1.0f, .limit = 0}};
  goal.joints = limited;
  goal.limits = &limit;
  goal.limit_count = 1;
  ASSERT_EQ(sinew_ik_set_aim(ik.get(), &goal), SINEW_OK);
  ASSERT_EQ(sinew_ik_solve(ik.get(), &local), SINEW_OK);
  EXPECT_EQ(result().status, static_cast<std::uint32_t>(SINEW_IK_LIMITED));
  EXPECT_GT(result().radians_left, 1.0f);
}

TEST_F(CIk, a_chain_meets_its_effector) {
  const sinew_chain_joint joints[] = {{1, SINEW_NONE, 0}, {2, SINEW_NONE, 0}};
  const sinew_chain_effector effector{3, {0.2, 0.5, 0.3}, {0, 0, 0, 1}, 1.0f, 0.0f};
  sinew_chain_goal goal = sinew_default_chain_goal();
  EXPECT_EQ(goal.solver, static_cast<std::uint32_t>(SINEW_SOLVER_FABRIK));
  goal.joints = joints;
  goal.joint_count = 2;
  goal.effectors = &effector;
  goal.effector_count = 1;
  goal.iterations = 60;
  ASSERT_EQ(sinew_ik_set_chain(ik.get(), &goal), SINEW_OK);
  ASSERT_EQ(sinew_ik_solve(ik.get(), &local), SINEW_OK);
  EXPECT_EQ(result().status, static_cast<std::uint32_t>(SINEW_IK_REACHED));
  EXPECT_GT(result().iterations, 0u);
  expect_hand(effector.target, 2e-4);
}

TEST_F(CIk, runs_as_a_procedure_of_a_program_and_its_version_follows_the_goal) {
  sinew_two_bone_goal goal = arm_goal();
  ASSERT_EQ(sinew_ik_set_two_bone(ik.get(), &goal), SINEW_OK);
  sinew_pose_procedure procedure{}, later{};
  ASSERT_EQ(sinew_ik_procedure(ik.get(), &procedure), SINEW_OK);
  EXPECT_NE(procedure.version, 0u);
  sinew_procedure_pose given{.struct_size = sizeof(given), .local = local, .share = 1.0f};
  procedure.run(procedure.context, &given);
  expect_hand(goal.target, 1e-6);
  ASSERT_EQ(sinew_ik_procedure(ik.get(), &later), SINEW_OK);
  EXPECT_EQ(later.version, procedure.version);
  goal.target.x = 0.2;
  ASSERT_EQ(sinew_ik_set_two_bone(ik.get(), &goal), SINEW_OK);
  ASSERT_EQ(sinew_ik_procedure(ik.get(), &later), SINEW_OK);
  EXPECT_NE(later.version, procedure.version);

  PoseBuffer other(7);  // of a skeleton LOD, say
  given.local = {other.span().planes, 7};
  procedure.run(procedure.context, &given);
  EXPECT_EQ(result().error, SINEW_SIZE_MISMATCH);
}

TEST_F(CIk, refusals_leave_the_goal_as_it_is) {
  const sinew_two_bone_goal good = arm_goal();
  ASSERT_EQ(sinew_ik_set_two_bone(ik.get(), &good), SINEW_OK);
  const auto refused = [&](auto change) {
    sinew_two_bone_goal goal = good;
    change(goal);
    return sinew_ik_set_two_bone(ik.get(), &goal);
  };
  EXPECT_EQ(refused([](auto& goal) { goal.tip = 9; }), SINEW_INDEX_OUT_OF_RANGE);
  EXPECT_EQ(refused([](auto& goal) { goal.tip = 1; }), SINEW_UNSUPPORTED);
  EXPECT_EQ(refused([](auto& goal) { goal.pole_kind = 4; }), SINEW_UNSUPPORTED);
  EXPECT_EQ(refused([](auto& goal) { goal.weight = 2; }), SINEW_NOT_A_FRACTION);
  EXPECT_EQ(refused([](auto& goal) { goal.target.y = std::numeric_limits<double>::infinity(); }), SINEW_NOT_FINITE);
  EXPECT_EQ(refused([](auto& goal) { goal.struct_size = 8; }), SINEW_WRONG_STRUCT_SIZE);
  sinew_aim_goal aim = sinew_default_aim_goal();
  EXPECT_EQ(sinew_ik_set_aim(ik.get(), &aim), SINEW_UNSUPPORTED) << "no joint";
  aim.joint_count = 1;
  EXPECT_EQ(sinew_ik_set_aim(ik.get(), &aim), SINEW_NULL_ARGUMENT);
  sinew_chain_goal chain = sinew_default_chain_goal();
  EXPECT_EQ(sinew_ik_set_chain(ik.get(), &chain), SINEW_UNSUPPORTED);
  ASSERT_EQ(sinew_ik_solve(ik.get(), &local), SINEW_OK);
  expect_hand(good.target, 1e-6);
}

TEST_F(CIk, null_arguments_are_refused_and_a_handle_without_a_goal_changes_nothing) {
  sinew_ik* out = nullptr;
  sinew_pose_procedure procedure{};
  sinew_ik_result told{.struct_size = sizeof(told)};
  const sinew_two_bone_goal goal = arm_goal();
  EXPECT_EQ(sinew_ik_create(nullptr, &out), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_ik_create(&scene, nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_ik_set_two_bone(nullptr, &goal), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_ik_set_two_bone(ik.get(), nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_ik_set_aim(ik.get(), nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_ik_set_chain(ik.get(), nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_ik_procedure(ik.get(), nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_ik_solve(ik.get(), nullptr), SINEW_NULL_ARGUMENT);
  EXPECT_EQ(sinew_get_ik_result(nullptr, &told), SINEW_NULL_ARGUMENT);
  sinew_ik_destroy(nullptr);
  ASSERT_EQ(sinew_ik_solve(ik.get(), &local), SINEW_OK);
  expect_hand({0, 0, 0}, 1e-7);
  ASSERT_EQ(sinew_ik_procedure(ik.get(), &procedure), SINEW_OK);
  EXPECT_EQ(result().status, static_cast<std::uint32_t>(SINEW_IK_IDLE));
}

}  // namespace
}  // namespace sinew::test
