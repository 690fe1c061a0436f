// SPDX-License-Identifier: MIT
#include "runtime/animation/mirror_animation.h"

#include <gtest/gtest.h>

#include "runtime/animation/track_sample.h"
#include "runtime/animation/truth_pose.h"
#include "tests/scenes/two_sided.h"
#include "tests/support/near.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using scenes::RightSide;
using scenes::TwoSided;
using Vec3d = Vec3<double>;

/// Tracks of every interpolation on most joints. For some pairs only one partner has tracks.
Animation moving(const Skeleton& skeleton) {
  test::FixedRandom random(9);
  const std::vector<float> times = {0.0f, 0.4f, 0.9f, 2.0f};
  Animation animation{"move", 2.0, {}, {}};
  for (std::uint32_t j = 0; j < skeleton.joint_count(); ++j) {
    if (j == 1 || j == 6 || j == 10) continue;
    const auto kind = static_cast<Interpolation>(j % 4);
    BoneAnimation bone;
    bone.joint = j;
    bone.rotation = test::random_rotations(random, kind, times);
    if (kind != Interpolation::squad) bone.translation = test::random_vectors(random, kind, times);
    if (j % 2 == 0) bone.scale = test::random_vectors(random, Interpolation::linear, times);
    animation.bones.push_back(bone);
  }
  return animation;
}

TEST(mirror_animation, at_any_time_it_is_the_mirrored_pose_of_that_time) {
  for (const RightSide right : scenes::kRightSides) {
    const TwoSided body = scenes::two_sided(right);
    const MirrorMap map = make_mirror_map(body.skeleton);
    const Animation animation = moving(body.skeleton), mirrored = mirror_animation(animation, map, body.skeleton);
    EXPECT_EQ(mirrored.bones.size(), animation.bones.size()) << "no track is added";
    for (const double time_s : {0.0, 0.2, 0.4, 0.65, 1.7, 2.0}) {
      TruthPose before, after;
      evaluate_truth(animation, body.skeleton, time_s, before);
      evaluate_truth(mirrored, body.skeleton, time_s, after);
      for (std::uint32_t j = 0; j < map.joints.size(); ++j) {
        const Transformd& source = before.local[map.joints[j].source];
        const Transform rounded{glm::vec3(source.translation), quat_cast<float>(source.rotation),
                                glm::vec3(source.scale)};
        const Transform expected = mirrored_transform(map, j, rounded);
        EXPECT_TRUE(test::is_near(after.local[j].translation, Vec3d(expected.translation), 2e-5)) << j << " " << time_s;
        EXPECT_LT(test::angle_between(after.local[j].rotation, expected.rotation), 2e-6) << j << " " << time_s;
        EXPECT_TRUE(test::is_near(after.local[j].scale, Vec3d(expected.scale), 1e-5)) << j << " " << time_s;
      }
    }
  }
}

TEST(mirror_animation, twice_mirrored_has_the_same_keys_bit_for_bit) {
  const TwoSided body = scenes::two_sided(RightSide::opposite_axes);
  const MirrorMap map = make_mirror_map(body.skeleton);
  const Animation animation = moving(body.skeleton),
                  twice = mirror_animation(mirror_animation(animation, map, body.skeleton), map, body.skeleton);
  ASSERT_EQ(twice.bones.size(), animation.bones.size());
  for (std::size_t b = 0; b < twice.bones.size(); ++b) {
    const BoneAnimation &a = animation.bones[b], &c = twice.bones[b];
    EXPECT_EQ(a.joint, c.joint);
    EXPECT_EQ(a.rotation.values, c.rotation.values);
    EXPECT_EQ(a.rotation.times_s, c.rotation.times_s);
    EXPECT_EQ(a.translation.values, c.translation.values);
    EXPECT_EQ(a.scale.values, c.scale.values);
  }
}

TEST(mirror_animation, tangents_take_no_offset) {
  const TwoSided body = scenes::two_sided(RightSide::another_posture);
  const MirrorMap map = make_mirror_map(body.skeleton);
  Animation animation{"still", 1.0, {}, {}};
  BoneAnimation& bone = animation.bones.emplace_back();
  bone.joint = 9;
  const glm::vec3 place = body.skeleton.rest[9].translation, none(0.0f);
  bone.translation = {Interpolation::cubic_spline, {0.0f, 1.0f}, {none, place, none, none, place, none}};
  const Animation mirrored = mirror_animation(animation, map, body.skeleton);
  EXPECT_EQ(mirrored.bones[0].joint, 10u);
  EXPECT_EQ(mirrored.bones[0].translation.values[0], none);
  EXPECT_TRUE(test::is_near(mirrored.bones[0].translation.values[1], body.skeleton.rest[10].translation, 1e-6));
  EXPECT_EQ(mirrored.bones[0].translation.values[2], none);
}

TEST(mirror_animation, morph_weights_go_to_their_partners) {
  const TwoSided body = scenes::two_sided(RightSide::mirrored_axes);
  MirrorMap map = make_mirror_map(body.skeleton);
  map.weight_source = {1, 0, 2, 3};
  const std::vector<std::uint32_t> first_weight = {0, 3, 4};
  Animation animation{"face", 1.0, {}, {}};
  animation.weights.push_back({0, {Interpolation::linear, {0.0f, 1.0f}, {1, 2, 3, 4, 5, 6}, 3}});
  animation.weights.push_back({0, {Interpolation::linear, {0.0f}, {7}, 1}, 1});
  const Animation mirrored = mirror_animation(animation, map, body.skeleton, first_weight);
  ASSERT_EQ(mirrored.weights.size(), 2u);
  EXPECT_EQ(mirrored.weights[0].weights.values, (std::vector<float>{2, 1, 3, 5, 4, 6}));
  EXPECT_EQ(mirrored.weights[1].first_target, 0u) << "the track of one target became one of its partner";
  EXPECT_EQ(mirrored.weights[1].weights.values, (std::vector<float>{7}));
  EXPECT_EQ(mirror_animation(animation, map, body.skeleton).weights[0].weights.values,
            animation.weights[0].weights.values);
}

TEST(mirror_animation, joints_without_a_track_get_a_constant_where_their_rest_is_not_the_reference) {
  const TwoSided body = scenes::two_sided(RightSide::mirrored_axes);
  Skeleton striding = body.skeleton;
  striding.rest[2].rotation = normalised(quat_xyzw(0.3f, 0.1f, 0.0f, 1.0f) * striding.rest[2].rotation);
  MirrorOptions options;
  options.reference = body.skeleton.rest;
  const MirrorMap map = make_mirror_map(striding, options);
  const Animation mirrored = mirror_animation({}, map, striding);
  ASSERT_EQ(mirrored.bones.size(), 2u);  // the leg that strides, and its partner
  for (const BoneAnimation& bone : mirrored.bones) {
    EXPECT_TRUE(bone.joint == 2 || bone.joint == 3);
    const Transform expected = mirrored_transform(map, bone.joint, striding.rest[bone.joint == 2 ? 3 : 2]);
    EXPECT_EQ(bone.rotation.values, (std::vector<glm::quat>{expected.rotation}));
    EXPECT_TRUE(bone.translation.empty());
  }
}

TEST(mirror_animation, tracks_come_before_constants_part_by_part) {
  const TwoSided body = scenes::two_sided(RightSide::mirrored_axes);
  Skeleton striding = body.skeleton;
  striding.rest[2].rotation = normalised(quat_xyzw(0.3f, 0.1f, 0.0f, 1.0f) * striding.rest[2].rotation);
  striding.rest[2].translation.y += 0.25f;
  MirrorOptions options;
  options.reference = body.skeleton.rest;
  const MirrorMap map = make_mirror_map(striding, options);
  ASSERT_EQ(map.joints[2].source, 3u);
  const glm::quat turned = striding.rest[2].rotation;
  Animation animation{"turn", 1.0, {}, {}};
  animation.bones.push_back({.joint = 2, .rotation = {Interpolation::linear, {0.0f, 1.0f}, {turned, turned}}});
  const Animation mirrored = mirror_animation(animation, map, striding);
  ASSERT_EQ(mirrored.bones.size(), 3u) << "the track, and what rests on either side";
  const auto rotations = [&](std::size_t b) { return mirrored.bones[b].rotation.values.size(); };
  EXPECT_EQ(mirrored.bones[0].joint, 3u);
  EXPECT_EQ(rotations(0), 2u);
  for (const std::size_t b : {1u, 2u}) {
    const std::uint32_t joint = mirrored.bones[b].joint;
    const Transform expected = mirrored_transform(map, joint, striding.rest[map.joints[joint].source]);
    EXPECT_EQ(mirrored.bones[b].translation.values, (std::vector<glm::vec3>{expected.translation})) << joint;
    EXPECT_EQ(rotations(b), joint == 2 ? 1u : 0u) << "the other one has a track";
    EXPECT_TRUE(mirrored.bones[b].scale.empty());
  }
}

}  // namespace
}  // namespace sinew
