// SPDX-License-Identifier: MIT
#include "runtime/retarget/retarget_animation.h"

#include <gtest/gtest.h>

#include "tests/scenes/two_sided.h"
#include "tests/support/near.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using scenes::RightSide;

/// Rotations of every interpolation on most joints; the hips move, and some joints have scales.
Animation moving(const Skeleton& skeleton, bool all_move = false) {
  test::FixedRandom random(9);
  const std::vector<float> times = {0.0f, 0.4f, 0.9f, 2.0f};
  Animation animation{"move", 2.0, {}, {}};
  for (std::uint32_t j = 0; j < skeleton.joint_count(); ++j) {
    if (j == 1 || j == 6) continue;
    const auto kind = static_cast<Interpolation>(j % 4);
    BoneAnimation bone;
    bone.joint = j;
    bone.rotation = test::random_rotations(random, kind, times);
    if (j == 0 || all_move)
      bone.translation =
          test::random_vectors(random, j % 2 == 0 ? Interpolation::cubic_spline : Interpolation::linear, times);
    if (all_move && j % 2 == 0) bone.scale = test::random_vectors(random, Interpolation::linear, times);
    animation.bones.push_back(bone);
  }
  return animation;
}

TEST(retarget_animation, on_its_own_skeleton_every_key_keeps_its_bits) {
  const Skeleton skeleton = scenes::two_sided(RightSide::any_axes).skeleton;
  const Animation animation = moving(skeleton, true);
  const Animation same = retarget_animation(animation, make_skeleton_map(skeleton, skeleton), skeleton, skeleton);
  ASSERT_EQ(same.bones.size(), animation.bones.size());
  for (std::size_t b = 0; b < same.bones.size(); ++b) {
    const BoneAnimation &a = animation.bones[b], &c = same.bones[b];
    EXPECT_EQ(a.joint, c.joint);
    EXPECT_EQ(a.rotation.values, c.rotation.values) << b;
    EXPECT_EQ(a.rotation.times_s, c.rotation.times_s) << b;
    EXPECT_EQ(a.rotation.interpolation, c.rotation.interpolation) << b;
    EXPECT_EQ(a.translation.values, c.translation.values) << b;
    EXPECT_EQ(a.scale.values, c.scale.values) << b;
  }
}

TEST(retarget_animation, at_every_time_it_is_the_retargeted_pose_where_one_track_moves_a_joint) {
  const Skeleton from = scenes::two_sided(RightSide::any_axes, 1).skeleton,
                 to = scenes::two_sided(RightSide::another_posture, 2).skeleton;
  const SkeletonMap map = make_skeleton_map(from, to);
  const Animation animation = moving(from, true), found = retarget_animation(animation, map, from, to);
  const RetargetError error = measure_retarget(found, animation, map, from, to);
  EXPECT_LT(error.angle_rad, 2e-6);
  EXPECT_LT(error.distance, 1e-5);
  EXPECT_EQ(found.bones.size(), animation.bones.size()) << "no track is added";
}

TEST(retarget_animation, there_and_back_again_is_the_same_within_rounding) {
  const Skeleton a = scenes::two_sided(RightSide::any_axes, 1).skeleton,
                 b = scenes::two_sided(RightSide::another_posture, 2).skeleton;
  const Animation animation = moving(a, true);
  const Animation there = retarget_animation(animation, make_skeleton_map(a, b), a, b),
                  back = retarget_animation(there, make_skeleton_map(b, a), b, a);
  ASSERT_EQ(back.bones.size(), animation.bones.size());
  for (std::size_t i = 0; i < back.bones.size(); ++i) {
    const BoneAnimation &before = animation.bones[i], &after = back.bones[i];
    for (std::size_t k = 0; k < before.rotation.values.size(); ++k)
      for (int c = 0; c < 4; ++c)
        EXPECT_NEAR(before.rotation.values[k][c], after.rotation.values[k][c], 8 * test::kEps);
    for (std::size_t k = 0; k < before.translation.values.size(); ++k)
      EXPECT_TRUE(test::is_near(before.translation.values[k], after.translation.values[k], 2e-6)) << i;
  }
}

/// The hand with the sword is several joints below its mapped ancestor. Each joint between moves alone, one property at
/// a time.
TEST(retarget_animation, each_joint_on_a_way_over_several_moves_what_is_seen_over_it) {
  const Skeleton from = scenes::two_sided(RightSide::any_axes, 1).skeleton;
  Skeleton to = scenes::two_sided(RightSide::another_posture, 2).skeleton;
  to.names[9] = to.names[11] = "something";
  SkeletonMapOptions options;
  options.translations = TranslationRule::by_length;
  const SkeletonMap map = make_skeleton_map(from, to, options);
  test::FixedRandom random(5);
  for (const std::uint32_t joint : {9u, 11u, 13u})
    for (int property = 0; property < 3; ++property) {
      if (joint == 13 && property == 2) continue;  // relative to its ancestor it has no scale
      Animation animation{"one", 1.0, {}, {}};
      BoneAnimation& bone = animation.bones.emplace_back();
      bone.joint = joint;
      const glm::vec3 place = from.rest[joint].translation;
      if (property == 0) bone.translation = {Interpolation::linear, {0.0f, 1.0f}, {place, 2.0f * place}};
      if (property == 1) bone.rotation = {Interpolation::step, {0.0f}, {random.rotation()}};
      if (property == 2) bone.scale = {Interpolation::linear, {0.0f, 1.0f}, {glm::vec3(1.0f), glm::vec3(1.5f)}};
      const Animation found = retarget_animation(animation, map, from, to);
      const RetargetError error = measure_retarget(found, animation, map, from, to);
      EXPECT_LT(error.angle_rad, 2e-6) << joint << " " << property;
      EXPECT_LT(error.distance, 2e-6) << joint << " " << property;
      const RetargetError still = measure_retarget({}, animation, map, from, to);
      EXPECT_GT(still.angle_rad + still.distance, 0.01) << joint << " " << property;
    }
}

TEST(retarget_animation, joints_that_add_up_are_sampled_and_the_error_is_measured) {
  const Skeleton from = scenes::two_sided(RightSide::any_axes, 1).skeleton;
  Skeleton to = scenes::two_sided(RightSide::any_axes, 2).skeleton;
  to.names[9] = "something";  // the hand takes over what the forearm does, too
  const SkeletonMap map = make_skeleton_map(from, to);
  Animation animation{"bend", 1.0, {}, {}};
  for (const std::uint32_t j : {9u, 11u}) {
    BoneAnimation& bone = animation.bones.emplace_back();
    bone.joint = j;
    const glm::quat rest = from.rest[j].rotation;
    bone.rotation = {Interpolation::linear,
                     {0.0f, j == 9 ? 0.5f : 0.7f, 1.0f},
                     {rest, rest * test::FixedRandom(j).rotation_by(0.4), rest}};
  }
  const Animation found = retarget_animation(animation, map, from, to);
  ASSERT_EQ(found.bones.size(), 1u);
  EXPECT_EQ(found.bones[0].joint, 11u);
  const std::vector<float> times = {0.0f, 0.25f, 0.5f, 0.6f, 0.7f, 0.85f, 1.0f};
  ASSERT_EQ(found.bones[0].rotation.times_s.size(), times.size()) << "four times, and the middles between";
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(found.bones[0].rotation.times_s[i], times[i], 1e-6f);
  const RetargetError error = measure_retarget(found, animation, map, from, to);
  EXPECT_LT(error.angle_rad, 0.01);
  EXPECT_GT(error.angle_rad, 1e-7);
  EXPECT_EQ(error.joint, 11u);
}

TEST(retarget_animation, one_joint_that_moves_among_others_that_rest_keeps_its_keys) {
  const Skeleton from = scenes::two_sided(RightSide::any_axes, 1).skeleton;
  Skeleton to = scenes::two_sided(RightSide::any_axes, 2).skeleton;
  to.names[9] = "something";  // the hand takes over what the forearm does, too
  const SkeletonMap map = make_skeleton_map(from, to);
  for (const std::uint32_t j : {9u, 11u}) {
    Animation animation{"bend", 1.0, {}, {}};
    const glm::quat rest = from.rest[j].rotation;
    animation.bones.push_back(
        {.joint = j,
         .rotation = {
             Interpolation::linear, {0.0f, 0.5f, 1.0f}, {rest, rest * test::FixedRandom(j).rotation_by(0.4), rest}}});
    const Animation found = retarget_animation(animation, map, from, to);
    ASSERT_EQ(found.bones.size(), 1u);
    EXPECT_EQ(found.bones[0].joint, 11u);
    EXPECT_EQ(found.bones[0].rotation.times_s, animation.bones[0].rotation.times_s);
    EXPECT_LT(measure_retarget(found, animation, map, from, to).angle_rad, 2e-6) << j;
  }
}

/// The forearm is mapped by itself, or lies between the hand and what the hand hangs from.
TEST(retarget_animation, tracks_of_a_joint_with_a_fixed_matrix_move_nothing) {
  for (const bool is_between : {false, true}) {
    Skeleton from = scenes::two_sided(RightSide::any_axes, 1).skeleton,
             to = scenes::two_sided(RightSide::another_posture, 2).skeleton;
    from.fixed_matrix_of[9] = 0;
    from.fixed_matrices = {affine_from_transform(from.rest[9])};
    if (is_between) to.names[9] = "something";
    const SkeletonMap map = make_skeleton_map(from, to, {.translations = TranslationRule::by_length});
    BoneAnimation moves{.joint = 9}, turns{.joint = 9}, grows{.joint = 9};
    moves.translation = {Interpolation::step, {0.0f}, {glm::vec3(3.0f)}};
    turns.rotation = {Interpolation::step, {0.0f}, {test::FixedRandom(4).rotation_by(1.0)}};
    grows.scale = {Interpolation::step, {0.0f}, {glm::vec3(2.0f)}};
    for (const BoneAnimation& bone : {moves, turns, grows}) {
      const Animation found = retarget_animation({"", 1.0, {bone}, {}}, map, from, to);
      EXPECT_TRUE(found.bones.empty()) << is_between << " " << bone.translation.key_count() << bone.scale.key_count();
    }
  }
}

TEST(retarget_animation, a_place_has_the_keys_of_its_own_track_and_of_those_above_it) {
  const Skeleton from = scenes::two_sided(RightSide::any_axes, 1).skeleton;
  Skeleton to = scenes::two_sided(RightSide::any_axes, 2).skeleton;
  to.names[9] = "something";  // the hand hangs from the upper arm, over the forearm
  const SkeletonMap map = make_skeleton_map(from, to, {.translations = TranslationRule::by_length});
  const auto moved = [&](std::uint32_t joint, float middle_s) {
    const glm::vec3 rest = from.rest[joint].translation;
    return BoneAnimation{
        .joint = joint,
        .translation = {Interpolation::linear, {0.0f, middle_s, 1.0f}, {rest, rest + glm::vec3(0.5f), rest}}};
  };
  const Animation animation{"", 1.0, {moved(9, 0.25f), moved(11, 0.75f)}, {}};
  const Animation found = retarget_animation(animation, map, from, to);
  ASSERT_EQ(found.bones.size(), 1u);
  EXPECT_EQ(found.bones[0].translation.times_s, (std::vector<float>{0, 0.125f, 0.25f, 0.5f, 0.75f, 0.875f, 1}));
  EXPECT_LT(measure_retarget(found, animation, map, from, to).distance, 2e-6);
}

TEST(retarget_animation, scales_come_from_the_joint_itself_and_not_over_joints_between) {
  const Skeleton from = scenes::two_sided(RightSide::any_axes, 1).skeleton;
  Skeleton to = from;
  to.names[9] = "something";  // the forearm
  for (Transform& rest : to.rest) rest.scale = {1.0f, 2.0f, 3.0f};
  Animation animation{"grow", 1.0, {}, {}};
  for (const std::uint32_t j : {5u, 9u, 11u})  // arm, forearm and hand
    animation.bones.push_back({.joint = j, .scale = {Interpolation::linear, {0, 1}, {glm::vec3(1), glm::vec3(2)}}});
  const Animation found = retarget_animation(animation, make_skeleton_map(from, to), from, to);
  std::vector<std::uint32_t> scaled;
  for (const BoneAnimation& bone : found.bones) {
    if (bone.scale.empty()) continue;
    scaled.push_back(bone.joint);
    EXPECT_EQ(bone.scale.values, (std::vector<glm::vec3>{{1, 2, 3}, {2, 4, 6}}));
  }
  EXPECT_EQ(scaled, (std::vector<std::uint32_t>{5})) << "the hand sees the arm over the forearm";
}

TEST(retarget_animation, the_error_is_the_largest_of_all_joints_and_times) {
  const Skeleton skeleton = scenes::two_sided(RightSide::any_axes).skeleton;
  const SkeletonMap map = make_skeleton_map(skeleton, skeleton);
  const Animation animation = moving(skeleton, true);
  for (std::size_t b = 0; b < animation.bones.size(); ++b) {
    Animation off = animation;
    BoneAnimation& bone = off.bones[b];
    const std::size_t key = b % 2 == 0 ? 3 : 1;  // value of the second key; for cubics that of the first
    bone.translation.values[bone.translation.interpolation == Interpolation::cubic_spline ? 1 : key] +=
        glm::vec3(0, 2, 0);
    bone.rotation = {Interpolation::step, {0.0f}, {quat_xyzw(0.0f, 0.0f, 0.0f, 1.0f)}};
    const RetargetError error = measure_retarget(off, animation, map, skeleton, skeleton);
    EXPECT_NEAR(error.distance, 2.0, 0.02) << b;
    EXPECT_EQ(error.joint, bone.joint);
    EXPECT_GT(error.angle_rad, 0.5) << b;
  }
}

TEST(retarget_animation, nothing_shifts_in_time) {
  const Skeleton from = scenes::two_sided(RightSide::any_axes, 1).skeleton,
                 to = scenes::two_sided(RightSide::any_axes, 2).skeleton;
  const Animation animation = moving(from),
                  found = retarget_animation(animation, make_skeleton_map(from, to), from, to);
  EXPECT_EQ(found.duration_s, animation.duration_s);
  for (std::size_t b = 0; b < found.bones.size(); ++b)
    EXPECT_EQ(found.bones[b].rotation.times_s, animation.bones[b].rotation.times_s);
}

}  // namespace
}  // namespace sinew
