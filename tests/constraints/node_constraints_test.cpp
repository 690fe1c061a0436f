// SPDX-License-Identifier: MIT
#include "runtime/procedures/constraints/node_constraints.h"

#include <gtest/gtest.h>

#include <numbers>
#include <utility>

#include "runtime/math/interpolate.h"
#include "runtime/math/rotation_between.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using Kind = NodeConstraint::Kind;
using Rotation = Quat<double>;
using Vec = Vec3<double>;

Rotation about(const Vec& axis, double degrees) {
  const double half = degrees * std::numbers::pi / 360.0;
  const Vec v = glm::normalize(axis) * std::sin(half);
  return quat_xyzw(v.x, v.y, v.z, std::cos(half));
}

/// Joint 0 has the children 1 and 2; 3 is below 1, 4 below 2.
struct Stage {
  Skeleton skeleton = test::skeleton_of({kNone, 0, 0, 1, 2});
  test::PoseBuffer pose{5};

  void place() {
    for (std::size_t j = 0; j < 5; ++j) pose.span().set(j, skeleton.rest[j]);
  }
  void turn(std::size_t joint, const Rotation& rotation) {
    pose.span().set_rotation(joint, quat_cast<float>(rotation));
  }
  Rotation rotation(std::size_t joint) { return quat_cast<double>(pose.span().get(joint).rotation); }
  ErrorCode apply(const std::vector<NodeConstraint>& list, float share = 1.0f) {
    const NodeConstraints sorted = sort_constraints(skeleton, list).value();
    const test::AllocationCounter counter;
    const ErrorCode code = run(NodeConstraintsJob{&sorted, &skeleton, pose.span(), share});
    EXPECT_EQ(counter.count(), 0u);
    return code;
  }
};

TEST(node_constraints, rotation_takes_over_the_turn_from_rest) {
  Stage stage;
  stage.skeleton.rest[1].rotation = quat_cast<float>(about({0, 1, 0}, 30));
  stage.place();
  stage.turn(1, about({0, 1, 0}, 30) * about({0, 0, 1}, 80));
  ASSERT_EQ(stage.apply({{Kind::rotation, 2, 1, {}, 0.5}}), ErrorCode::ok);
  EXPECT_TRUE(test::same_rotation(stage.rotation(2), about({0, 0, 1}, 40), 1e-6));
}

TEST(node_constraints, roll_leaves_the_swing_behind) {
  Stage stage;
  stage.place();
  stage.turn(1, about({1, 0, 0}, 50) * about({0, 1, 0}, 20));
  ASSERT_EQ(stage.apply({{Kind::roll, 2, 1, {0, 1, 0}, 1.0}}), ErrorCode::ok);
  EXPECT_TRUE(test::same_rotation(stage.rotation(2), about({0, 1, 0}, 20), 1e-6));
}

TEST(node_constraints, aim_turns_the_axis_to_the_source) {
  Stage stage;
  stage.skeleton.rest[1].translation = {3, 0, 0};
  stage.place();
  stage.turn(0, about({0, 1, 1}, 70));
  ASSERT_EQ(stage.apply({{Kind::aim, 2, 1, {0, 1, 0}, 1.0}}), ErrorCode::ok);
  EXPECT_TRUE(test::is_near(rotate_vector(stage.rotation(2), Vec(0, 1, 0)), Vec(1, 0, 0), 1e-6));
}

TEST(node_constraints, aim_at_its_own_place_keeps_the_rest) {
  Stage stage;
  stage.skeleton.rest[2].rotation = quat_cast<float>(about({1, 0, 0}, 10));
  stage.place();
  stage.turn(2, about({1, 2, 0}, 90));
  ASSERT_EQ(stage.apply({{Kind::aim, 2, 1, {0, 1, 0}, 1.0}}), ErrorCode::ok);
  EXPECT_TRUE(test::same_rotation(stage.rotation(2), about({1, 0, 0}, 10), 1e-6));
}

TEST(node_constraints, share_mixes_with_the_pose) {
  Stage stage;
  stage.place();
  stage.turn(1, about({0, 0, 1}, 80));
  ASSERT_EQ(stage.apply({{Kind::rotation, 2, 1, {}, 1.0}}, 0.25f), ErrorCode::ok);
  EXPECT_TRUE(test::same_rotation(stage.rotation(2), about({0, 0, 1}, 20), 1e-6));
  EXPECT_EQ(stage.apply({{Kind::rotation, 2, 1, {}, 1.0}}, 2.0f), ErrorCode::not_a_fraction);
}

TEST(node_constraints, refuses_the_pose_of_another_skeleton) {
  Stage stage;
  const NodeConstraints sorted = sort_constraints(stage.skeleton, {}).value();
  test::PoseBuffer small(2);
  EXPECT_EQ(check(NodeConstraintsJob{&sorted, &stage.skeleton, small.span()}), ErrorCode::size_mismatch);
  EXPECT_EQ(check(NodeConstraintsJob{nullptr, &stage.skeleton, stage.pose.span()}), ErrorCode::size_mismatch);
}

Rotation random_turn(test::FixedRandom& random) {
  return normalised(quat_xyzw(random.normal(), random.normal(), random.normal(), random.normal()));
}

/// Position and rotation of a joint in the model, where nothing is scaled.
std::pair<Vec, Rotation> model_place(Stage& stage, std::uint32_t joint) {
  Vec at(0.0);
  Rotation rotation = quat_identity<double>();
  for (; joint != kNone; joint = stage.skeleton.parents[joint]) {
    const Rotation turn = normalised(stage.rotation(joint));
    at = Vec(stage.pose.span().get(joint).translation) + rotate_vector(turn, at);
    rotation = turn * rotation;
  }
  return {at, rotation};
}

/// The equations of VRMC_node_constraint 1.0, with rotations in the model as its text has them.
Rotation truth(Stage& stage, const NodeConstraint& c) {
  const auto rest_of = [&](std::uint32_t j) { return normalised(quat_cast<double>(stage.skeleton.rest[j].rotation)); };
  const Rotation rest = rest_of(c.joint), source_rest = rest_of(c.source);
  const Rotation turn = quat_conjugate(source_rest) * normalised(stage.rotation(c.source));
  if (c.kind == Kind::rotation) return slerp_short_arc(rest, rest * turn, c.weight);
  if (c.kind == Kind::roll) {
    const Rotation in_parent = source_rest * turn * quat_conjugate(source_rest);
    const Rotation here = quat_conjugate(rest) * in_parent * rest;
    const Rotation swing = rotation_between(c.axis, rotate_vector(here, c.axis));
    return slerp_short_arc(rest, rest * quat_conjugate(swing) * here, c.weight);
  }
  const Rotation parent = model_place(stage, stage.skeleton.parents[c.joint]).second;
  const Vec from = rotate_vector(parent * rest, c.axis);
  const Vec to = model_place(stage, c.source).first - model_place(stage, c.joint).first;
  const Rotation goal = quat_conjugate(parent) * rotation_between(from, to) * parent * rest;
  return slerp_short_arc(rest, goal, c.weight);
}

TEST(node_constraints, agree_with_the_specification_for_random_poses) {
  test::FixedRandom random(7);
  for (int trial = 0; trial < 300; ++trial) {
    Stage stage;
    for (Transform& rest : stage.skeleton.rest)
      rest = {random.vec3(), quat_cast<float>(random_turn(random)), glm::vec3(1.0f)};
    stage.place();
    for (std::size_t j = 0; j < 5; ++j) stage.turn(j, random_turn(random));
    const Vec axes[] = {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
    const NodeConstraint constraint{static_cast<Kind>(trial % 3), 3, 4, axes[random.below(3)], random.unit()};
    const Rotation expected = truth(stage, constraint);
    ASSERT_EQ(stage.apply({constraint}), ErrorCode::ok);
    ASSERT_TRUE(test::same_rotation(stage.rotation(3), expected, 1e-5)) << trial;
  }
}

}  // namespace
}  // namespace sinew
