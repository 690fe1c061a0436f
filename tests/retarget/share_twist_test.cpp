// SPDX-License-Identifier: MIT
#include "runtime/retarget/share_twist.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

#include "runtime/animation/truth_pose.h"
#include "runtime/math/axis_angle.h"
#include "runtime/retarget/humanoid_bones.h"
#include "tests/scenes/skeletons.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using testing::ElementsAre;
using Quatd = Quat<double>;
using Vec3d = Vec3<double>;

enum Joint : std::uint32_t { upper, upper_twist, lower, lower_twist, roll, hand, strap, helper };

/// An arm with twist joints beside both bones, each joint with axes of its own: the bones go along no axis of theirs.
/// `strap` lies aside of the lower bone, and `helper` on it without a telling name.
Skeleton arm(std::uint64_t seed) {
  test::FixedRandom random(seed);
  Skeleton skeleton =
      scenes::breadth_first({kNone, upper, upper, lower, lower, lower, lower, lower}, std::vector<glm::vec3>(8));
  const char* names[] = {"upperarm_l", "upperarm_twist_01_l", "lowerarm_l", "lowerarm_twist_01_l", "ForeArmRoll_l",
                         "hand_l",     "strap_twist_l",       "helper_l"};
  const glm::vec3 along_upper = glm::normalize(glm::vec3(1, 2, -2)), along_lower = glm::normalize(glm::vec3(-2, 1, 2));
  const glm::vec3 aside = along_lower * 0.15f + glm::normalize(glm::vec3(1, 0, 1)) * 0.1f;
  const glm::vec3 places[] = {
      {0, 1, 0}, along_upper * 0.1f, along_upper * 0.4f, along_lower * 0.15f, along_lower * 0.3f, along_lower * 0.3f,
      aside,     along_lower * 0.1f};
  for (std::uint32_t j = 0; j < 8; ++j) {
    skeleton.names[j] = names[j];
    skeleton.rest[j] = {places[j], quat_cast<float>(random.rotation<double>()), glm::vec3(1.0f)};
  }
  return skeleton;
}

TwistMap twists_of(const Skeleton& skeleton, std::vector<std::uint32_t> moved = {upper, lower, hand}) {
  SkeletonMap map;
  map.target_bones = find_humanoid_bones(skeleton);
  for (std::uint32_t j = 0; j < skeleton.joint_count(); ++j)
    if (std::find(moved.begin(), moved.end(), j) == moved.end()) map.unmapped_target.push_back(j);
  return make_twist_map(map, skeleton);
}

std::vector<Transformd> rest_of(const Skeleton& skeleton) {
  std::vector<Transformd> pose;
  for (const Transform& rest : skeleton.rest) pose.push_back(in_double(rest));
  return pose;
}

TEST(twist_map, finds_joints_beside_the_bones_of_limbs_by_name_and_place) {
  const Skeleton skeleton = arm(1);
  const TwistMap twists = twists_of(skeleton);
  ASSERT_EQ(twists.joints.size(), 3u);
  EXPECT_EQ(twists.joints[0].joint, upper_twist);
  EXPECT_EQ(twists.joints[0].driver, upper);
  EXPECT_TRUE(twists.joints[0].is_below_driver);
  EXPECT_NEAR(twists.joints[0].share, -0.75, 1e-6);
  EXPECT_EQ(twists.joints[1].joint, lower_twist);
  EXPECT_EQ(twists.joints[1].driver, hand);
  EXPECT_NEAR(twists.joints[1].share, 0.5, 1e-6);
  EXPECT_EQ(twists.joints[2].joint, roll);
  EXPECT_NEAR(twists.joints[2].share, 1.0, 1e-6);
}

TEST(twist_map, of_small_and_large_bodies_is_the_same) {
  const TwistMap twists = twists_of(arm(1));
  for (const float scale : {0.01f, 100.0f}) {
    Skeleton skeleton = arm(1);
    for (Transform& rest : skeleton.rest) rest.translation *= scale;
    const TwistMap scaled = twists_of(skeleton);
    ASSERT_EQ(scaled.joints.size(), twists.joints.size()) << scale;
    for (std::size_t i = 0; i < twists.joints.size(); ++i) {
      EXPECT_EQ(scaled.joints[i].joint, twists.joints[i].joint);
      EXPECT_NEAR(scaled.joints[i].share, twists.joints[i].share, 1e-6);
    }
  }
}

TEST(twist_map, a_joint_a_little_beyond_the_ends_of_its_bone_takes_all_of_the_twist_or_none) {
  for (const auto& [along, of_upper, of_lower] : {std::tuple{-0.05f, -1.0, 0.0}, {1.05f, 0.0, 1.0}}) {
    Skeleton skeleton = arm(1);
    skeleton.rest[upper_twist].translation = skeleton.rest[lower].translation * along;
    skeleton.rest[lower_twist].translation = skeleton.rest[hand].translation * along;
    const TwistMap twists = twists_of(skeleton);
    ASSERT_EQ(twists.joints.size(), 3u);
    EXPECT_EQ(twists.joints[0].share, of_upper);
    EXPECT_EQ(twists.joints[1].share, of_lower);
  }
}

TEST(twist_map, leaves_out_what_clips_move_what_is_fixed_and_bones_in_a_chain) {
  const Skeleton skeleton = arm(1);
  EXPECT_EQ(twists_of(skeleton, {upper, lower, hand, lower_twist}).joints.size(), 2u);
  Skeleton fixed = skeleton;
  fixed.fixed_matrix_of[hand] = 0;
  fixed.fixed_matrices = {affine_from_transform(skeleton.rest[hand])};
  EXPECT_EQ(twists_of(fixed).joints.size(), 1u) << "the upper one";
  Skeleton chain = skeleton;
  chain.parents[hand] = lower_twist;
  EXPECT_EQ(twists_of(chain).joints.size(), 1u) << "the upper one";
}

TEST(share_twist, a_pose_at_rest_stays_at_rest) {
  const Skeleton skeleton = arm(2);
  std::vector<Transformd> pose = rest_of(skeleton);
  share_twist(twists_of(skeleton), pose);
  for (std::uint32_t j = 0; j < pose.size(); ++j)
    EXPECT_LE(rotation_angle_between(pose[j].rotation, in_double(skeleton.rest[j]).rotation), 1e-7) << j;
}

/// Whatever the hand swings, and by up to almost half a turn either way.
TEST(share_twist, joints_of_the_lower_bone_turn_by_their_share_of_the_hand_s_twist) {
  const Skeleton skeleton = arm(3);
  const TwistMap twists = twists_of(skeleton);
  test::FixedRandom random(5);
  for (const double angle : {-3.0, -1.0, 1e-9, 0.5, 2.0, 3.1}) {
    std::vector<Transformd> pose = rest_of(skeleton);
    const Vec3d along = glm::normalize(pose[hand].translation);
    const Vec3d across = glm::normalize(glm::cross(along, Vec3d(0.3, 0.5, 0.7)));
    const Quatd swing = quat_from_axis_angle(across, random.in(-1.0, 1.0));
    pose[hand].rotation = swing * quat_from_axis_angle(along, angle) * pose[hand].rotation;
    if (angle > 1.0) pose[hand].rotation = -pose[hand].rotation;  // the same rotation
    share_twist(twists, pose);
    const Quatd half = quat_from_axis_angle(along, 0.5 * angle) * in_double(skeleton.rest[lower_twist]).rotation,
                whole = quat_from_axis_angle(along, angle) * in_double(skeleton.rest[roll]).rotation;
    EXPECT_LE(rotation_angle_between(pose[lower_twist].rotation, half), 1e-6) << angle;
    EXPECT_LE(rotation_angle_between(pose[roll].rotation, whole), 1e-6) << angle;
  }
}

/// A joint at a quarter of the upper arm takes back three quarters of its twist.
TEST(share_twist, joints_of_the_upper_bone_take_back_the_rest_of_its_twist) {
  const Skeleton skeleton = arm(4);
  std::vector<Transformd> pose = rest_of(skeleton);
  const Vec3d along = glm::normalize(pose[lower].translation);
  const Vec3d across = glm::normalize(glm::cross(along, Vec3d(0.3, 0.5, 0.7)));
  pose[upper].rotation = pose[upper].rotation * quat_from_axis_angle(across, 0.7) * quat_from_axis_angle(along, 1.2);
  share_twist(twists_of(skeleton), pose);
  const Quatd expected = quat_from_axis_angle(along, -0.75 * 1.2) * in_double(skeleton.rest[upper_twist]).rotation;
  EXPECT_LE(rotation_angle_between(pose[upper_twist].rotation, expected), 1e-6);
}

TEST(share_twist, the_job_has_the_bits_of_the_truth_in_float_and_allocates_nothing) {
  const Skeleton skeleton = arm(5);
  const TwistMap twists = twists_of(skeleton);
  test::PoseBuffer memory(8);
  test::FixedRandom random(9);
  std::vector<Transformd> pose = rest_of(skeleton);
  for (const std::uint32_t j : {upper, lower, hand}) pose[j].rotation = random.rotation<double>();
  for (std::uint32_t j = 0; j < 8; ++j)
    memory.span().set(j, {glm::vec3(pose[j].translation), quat_cast<float>(pose[j].rotation), glm::vec3(1.0f)});
  for (std::uint32_t j = 0; j < 8; ++j) pose[j] = in_double(memory.span().get(j));
  const ShareTwistJob job{&twists, memory.span()};
  ASSERT_EQ(check(job), ErrorCode::ok);
  const test::AllocationCounter allocations;
  EXPECT_EQ(run(job), ErrorCode::ok);
  EXPECT_EQ(allocations.count(), 0u);
  share_twist(twists, pose);
  for (std::uint32_t j = 0; j < 8; ++j) {
    EXPECT_EQ(memory.span().get(j).rotation, quat_cast<float>(pose[j].rotation)) << j;
    EXPECT_EQ(memory.span().get(j).translation, glm::vec3(pose[j].translation)) << j;
  }
  test::PoseBuffer small(5);
  EXPECT_EQ(check(ShareTwistJob{&twists, small.span()}), ErrorCode::size_mismatch);
  EXPECT_EQ(check(ShareTwistJob{nullptr, memory.span()}), ErrorCode::size_mismatch);
}

/// Between keys, linear ones of the shares follow the shares of what moves between, also where the hand swings.
TEST(share_twist, an_animation_has_the_shares_of_its_poses) {
  const Skeleton skeleton = arm(6);
  const TwistMap twists = twists_of(skeleton);
  test::FixedRandom random(3);
  Animation animation{"reach", 1.0, {}, {}};
  for (const std::uint32_t j : {upper, lower, hand}) {
    BoneAnimation bone;
    bone.joint = j;
    bone.rotation = {Interpolation::linear, {0.0f, 0.4f, 1.0f}, {}};
    for (int k = 0; k < 3; ++k)
      bone.rotation.values.push_back(
          quat_cast<float>(random.rotation_by<double>(0.4) * in_double(skeleton.rest[j]).rotation));
    animation.bones.push_back(bone);
  }
  share_twist(twists, animation);
  ASSERT_EQ(animation.bones.size(), 6u);
  TruthPose found;
  for (double time_s = 0.0; time_s <= 1.0; time_s += 0.0173) {
    evaluate_truth(animation, skeleton, time_s, found);
    std::vector<Transformd> expected = found.local;
    share_twist(twists, expected);
    for (const TwistJoint& twist : twists.joints)
      EXPECT_LE(rotation_angle_between(found.local[twist.joint].rotation, expected[twist.joint].rotation), 1e-4);
  }
}

TEST(share_twist, only_rotations_of_twist_joints_are_replaced_the_last_where_there_are_two) {
  const Skeleton skeleton = arm(7);
  BoneAnimation turned, moved, turned_too;
  turned.joint = hand;
  moved.joint = turned_too.joint = roll;
  turned.rotation = {Interpolation::step, {0.25f}, {{0, 1, 0, 0}}};
  turned_too.rotation = {Interpolation::step, {0.5f}, {{0, 0, 1, 0}}};
  moved.translation = moved.scale = {Interpolation::linear, {0.5f}, {{1, 2, 3}}};
  moved.rotation = turned_too.rotation;
  Animation animation{"snap", 1.0, {moved, turned, turned_too}, {}};
  share_twist(twists_of(skeleton), animation);
  ASSERT_EQ(animation.bones.size(), 4u) << "that of the other joint of the lower arm is new";
  EXPECT_EQ(animation.bones[0].translation.values, moved.translation.values);
  EXPECT_EQ(animation.bones[0].scale.values, moved.scale.values);
  TruthPose found;
  evaluate_truth(animation, skeleton, 0.5, found);
  std::vector<Transformd> expected = found.local;
  share_twist(twists_of(skeleton), expected);
  EXPECT_LE(rotation_angle_between(found.local[roll].rotation, expected[roll].rotation), 1e-6);
}

TEST(share_twist, keys_that_step_stay_as_many_and_what_is_not_driven_rests) {
  const Skeleton skeleton = arm(7);
  Animation animation{"snap", 1.0, {}, {}};
  BoneAnimation turned;
  turned.joint = hand;
  turned.rotation = {Interpolation::step, {0.25f, 0.75f}, {skeleton.rest[hand].rotation, {0, 1, 0, 0}}};
  animation.bones = {turned};
  share_twist(twists_of(skeleton), animation);
  ASSERT_EQ(animation.bones.size(), 3u) << "both joints of the lower arm, not that of the upper";
  for (const BoneAnimation& bone : {animation.bones[1], animation.bones[2]}) {
    EXPECT_EQ(bone.rotation.interpolation, Interpolation::step);
    EXPECT_THAT(bone.rotation.times_s, ElementsAre(0.25f, 0.75f));
  }
}

}  // namespace
}  // namespace sinew
