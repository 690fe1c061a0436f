// SPDX-License-Identifier: MIT
#include "runtime/compress/joint_reach.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

constexpr double kCorner = 0.03 * 1.7320508075688772;  // distance from a joint to a corner of its box

/// Bones of length 0.2 along y.
Skeleton chain(std::uint32_t joints) {
  Skeleton skeleton = test::chain_skeleton(joints);
  for (std::uint32_t j = 1; j < joints; ++j) skeleton.rest[j].translation.y = 0.2f;
  return skeleton;
}

std::vector<JointReach> reach_of(const Skeleton& skeleton, Animation animation = {}) {
  return joint_reach(animation, skeleton, virtual_vertices(skeleton));
}

TEST(joint_reach, a_turn_reaches_the_farthest_corner_of_all_joints_below) {
  const auto reach = reach_of(chain(3));
  ASSERT_EQ(reach.size(), 3u);
  for (std::size_t j = 0; j < 3; ++j) {
    const double radius = 0.2 * static_cast<double>(2 - j) + kCorner;
    EXPECT_NEAR(reach[j].rotation, radius, 1e-7) << j;
    EXPECT_NEAR(reach[j].scale, radius, 1e-7) << j;
    EXPECT_NEAR(reach[j].translation, 1.0, 1e-12) << j;
  }
}

TEST(joint_reach, of_several_branches_the_longest_counts) {
  for (const bool first : {true, false}) {
    Skeleton skeleton = test::skeleton_of({kNone, 0, 0});
    skeleton.rest[first ? 1 : 2].translation = {3, 0, 4};
    skeleton.rest[first ? 2 : 1].translation = {0, 1, 0};
    const auto reach = reach_of(skeleton);
    EXPECT_NEAR(reach[0].rotation, 5.0 + kCorner, 1e-6);
    EXPECT_NEAR(reach[1].rotation, kCorner, 1e-7);
    EXPECT_NEAR(reach[2].rotation, kCorner, 1e-7);
  }
}

TEST(joint_reach, the_box_of_a_joint_counts_where_it_reaches_farther_than_its_children) {
  const Skeleton skeleton = chain(2);
  VirtualVertices vertices = virtual_vertices(skeleton);
  vertices.boxes[0] = {{0, 0, 0}, {2, 3, 6}};
  const auto reach = joint_reach({}, skeleton, vertices);
  EXPECT_NEAR(reach[0].rotation, 7.0, 1e-9);
  EXPECT_NEAR(reach[1].rotation, kCorner, 1e-7);
}

TEST(joint_reach, scales_above_stretch_translations_and_turns_and_a_joints_own_divides_its_scale) {
  Skeleton skeleton = chain(3);
  skeleton.rest[1].scale = {-4, 5, 8};
  const auto reach = reach_of(skeleton);
  EXPECT_NEAR(reach[0].translation, 1.0, 1e-12);
  EXPECT_NEAR(reach[1].translation, 1.0, 1e-12) << "its own scale does not move it";
  EXPECT_GE(reach[2].translation, 8.0) << "an upper bound";
  EXPECT_LT(reach[2].translation, 8.0 * 1.3);
  const double tip = 0.03 * std::sqrt(4.0 * 4.0 + 5.0 * 5.0 + 8.0 * 8.0);  // distance to a corner of the tip's box
  EXPECT_NEAR(reach[2].rotation, tip, 1e-6);
  EXPECT_NEAR(reach[1].rotation, 5.0 * 0.2 + tip, 1e-6);
  EXPECT_NEAR(reach[1].scale, (5.0 * 0.2 + tip) / 4.0, 1e-6) << "the smallest scale, without its sign";
  EXPECT_NEAR(reach[0].rotation, 0.2 + 5.0 * 0.2 + tip, 1e-6);
}

TEST(joint_reach, the_smallest_scale_counts_whichever_axis_it_is_along) {
  for (int axis = 0; axis < 3; ++axis) {
    Skeleton skeleton = chain(1);
    skeleton.rest[0].scale = {8, 8, 8};
    skeleton.rest[0].scale[axis] = axis == 1 ? -2.0f : 2.0f;
    const auto reach = reach_of(skeleton);
    EXPECT_NEAR(reach[0].rotation, 0.03 * std::sqrt(8.0 * 8.0 * 2.0 + 2.0 * 2.0), 1e-6);
    EXPECT_NEAR(reach[0].scale, reach[0].rotation / 2.0, 1e-6) << axis;
  }
}

TEST(joint_reach, a_scale_of_zero_reaches_nowhere) {
  Skeleton skeleton = chain(2);
  skeleton.rest[1].scale = {1, 0, 1};
  EXPECT_EQ(reach_of(skeleton)[1].scale, 0.0);
}

/// Moves the second joint of a chain along y by these lengths at even times within one second.
Animation stretching(std::initializer_list<float> lengths) {
  BoneAnimation bone;
  bone.joint = 1;
  for (const float length : lengths) {
    bone.translation.times_s.push_back(static_cast<float>(bone.translation.times_s.size()));
    bone.translation.values.push_back({0, length, 0});
  }
  return test::animation_of({bone});
}

TEST(joint_reach, of_all_poses_of_a_clip_the_largest_counts_its_ends_included) {
  const Skeleton skeleton = chain(2);
  EXPECT_NEAR(reach_of(skeleton, stretching({7, 1}))[0].rotation, 7.0 + kCorner, 1e-6);
  EXPECT_NEAR(reach_of(skeleton, stretching({1, 7}))[0].rotation, 7.0 + kCorner, 1e-6);
  const Animation peak = stretching({1, 1, 1, 7, 1, 1});  // the peak takes a fifth of the clip: three of fifteen steps
  EXPECT_NEAR(reach_of(skeleton, peak)[0].rotation, 7.0 + kCorner, 1e-6);
}

}  // namespace
}  // namespace sinew
