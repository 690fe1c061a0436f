// SPDX-License-Identifier: MIT
#include "runtime/animation/joint_tracks.h"

#include <gtest/gtest.h>

namespace sinew {
namespace {

BoneAnimation of_joint(std::uint32_t joint) {
  BoneAnimation bone;
  bone.joint = joint;
  return bone;
}

const Vec3Track kMoves{Interpolation::linear, {0.0f}, {{1, 2, 3}}};
const QuatTrack kTurns{Interpolation::linear, {0.0f}, {{0, 1, 0, 0}}};

/// Entries in this order: translation and rotation of joint 2, scale of joint 0, rotation and scale of joint 2.
Animation joined() {
  Animation animation;
  animation.bones = {of_joint(2), of_joint(0), of_joint(2)};
  animation.bones[0].translation = animation.bones[1].scale = animation.bones[2].scale = kMoves;
  animation.bones[0].rotation = animation.bones[2].rotation = kTurns;
  return animation;
}

void expect_tracks_of_2(const JointTracks& tracks, const Animation& animation) {
  EXPECT_EQ(tracks.translation, &animation.bones[0].translation);
  EXPECT_EQ(tracks.rotation, &animation.bones[2].rotation);
  EXPECT_EQ(tracks.scale, &animation.bones[2].scale);
}

TEST(joint_tracks, G20_of_two_for_one_property_the_last_counts_and_others_join) {
  const Animation animation = joined();
  expect_tracks_of_2(tracks_of_joint(animation, 2), animation);
  const std::vector<JointTracks> tracks = tracks_by_joint(animation, 4);
  ASSERT_EQ(tracks.size(), 4u);
  expect_tracks_of_2(tracks[2], animation);
  EXPECT_EQ(tracks[0].scale, &animation.bones[1].scale);
  EXPECT_EQ(tracks[0].translation, nullptr);
  EXPECT_EQ(tracks[0].rotation, nullptr);
}

TEST(joint_tracks, are_null_where_the_joint_rests) {
  const Animation animation = joined();
  for (const JointTracks& tracks : {tracks_of_joint(animation, 1), tracks_by_joint(animation, 4)[3]}) {
    EXPECT_EQ(tracks.translation, nullptr);
    EXPECT_EQ(tracks.rotation, nullptr);
    EXPECT_EQ(tracks.scale, nullptr);
  }
}

TEST(joint_tracks, a_track_put_into_the_last_bone_counts) {
  Animation animation = joined();
  EXPECT_EQ(&last_bone_of(animation, 2), &animation.bones[2]);
  EXPECT_EQ(&last_bone_of(animation, 0), &animation.bones[1]);
  EXPECT_EQ(animation.bones.size(), 3u);
  BoneAnimation& added = last_bone_of(animation, 5);
  EXPECT_EQ(&added, &animation.bones[3]);
  EXPECT_EQ(added.joint, 5u);
  EXPECT_TRUE(added.empty());
}

}  // namespace
}  // namespace sinew
