// SPDX-License-Identifier: MIT
#include "runtime/clip/clip_rest.h"

#include <gtest/gtest.h>

#include <array>

#include "runtime/base/same_bits.h"
#include "runtime/clip/clip_file.h"
#include "runtime/clip/clip_layout.h"
#include "runtime/clip/keep_joints.h"
#include "runtime/pose/sample_clip.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using test::animation_of;

constexpr std::uint32_t kJoints = 2000;

Skeleton wide_skeleton(std::uint32_t joints) {
  Skeleton skeleton = test::skeleton_of(std::vector<std::uint32_t>(joints, kNone));
  test::FixedRandom random(3);
  for (Transform& rest : skeleton.rest) rest = random.transform();
  return skeleton;
}

/// An animation with a joint that turns, and one with a constant translation.
Animation small_animation(std::uint32_t turned, std::uint32_t held) {
  BoneAnimation turn, hold;
  turn.joint = turned;
  turn.rotation = {
      Interpolation::linear, {0, 1}, {quat_xyzw(0.0f, 0.0f, 0.0f, 1.0f), quat_xyzw(0.6f, 0.0f, 0.0f, 0.8f)}};
  hold.joint = held;
  hold.translation = {Interpolation::step, {0}, {{1, 2, 3}}};
  return animation_of({turn, hold});
}

std::vector<float> planes_at(const Clip& clip, double time_s) {
  test::PoseBuffer pose(clip.joint_count());
  const SampleClipJob job{.clip = &clip, .time_s = time_s, .pose = pose.span()};
  EXPECT_EQ(check(job), ErrorCode::ok);
  EXPECT_EQ(run(job), ErrorCode::ok);
  const float* planes = pose.span().planes;
  return {planes, planes + PoseSpan::floats_for(clip.joint_count())};
}

void expect_same_poses(const Clip& a, const Clip& b) {
  for (const double time_s : {0.0, 0.3, 1.0})
    EXPECT_TRUE(same_bits<float>(planes_at(a, time_s), planes_at(b, time_s))) << time_s;
}

TEST(clip_rest, a_clip_takes_memory_for_what_it_moves) {
  std::array<std::size_t, 2> bytes{};
  for (const std::size_t i : {0u, 1u}) {
    const Skeleton skeleton = wide_skeleton(i == 0 ? 100 : kJoints);
    const Clip clip = compile_clip(small_animation(7, 40), clip_rest(skeleton, {}, {}), {});
    bytes[i] = clip.byte_size();
  }
  EXPECT_EQ(bytes[0], bytes[1]);
  EXPECT_LT(bytes[1], 400u);
}

TEST(clip_rest, clips_of_one_rest_share_it_and_sample_like_clips_with_their_own) {
  const Skeleton skeleton = wide_skeleton(kJoints);
  const ClipRest rest = clip_rest(skeleton, {}, {});
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Animation animation = small_animation(i, 1000 + i);
    const Clip clip = compile_clip(animation, rest, {});
    EXPECT_EQ(clip.layout().base_pose.rest(), rest.pose);
    expect_same_poses(clip, compile_clip(animation, skeleton, {}, {}));
  }
}

TEST(clip_rest, equal_numbers_are_taken_from_a_clip) {
  const Skeleton skeleton = wide_skeleton(30);
  const Clip clip = compile_clip(small_animation(1, 2), skeleton, {}, {});
  ClipRest rest = clip_rest(skeleton, {}, {});
  EXPECT_NE(rest.pose, clip.layout().base_pose.rest());
  share_rest(clip, rest);
  EXPECT_EQ(rest.pose, clip.layout().base_pose.rest());
  ClipRest other = clip_rest(wide_skeleton(31), {}, {});
  const RestNumbers before = other.pose;
  share_rest(clip, other);
  EXPECT_EQ(other.pose, before);
}

TEST(clip_rest, loaded_clips_share_what_they_agree_in) {
  const Skeleton skeleton = wide_skeleton(kJoints);
  const ClipRest rest = clip_rest(skeleton, {}, {});
  const Clip clips[] = {compile_clip(small_animation(5, 6), rest, {}),
                        compile_clip(small_animation(1900, 3), rest, {})};
  const Clip* const both[] = {&clips[0], &clips[1]};
  const auto loaded = load_clips(save_clips(both));
  ASSERT_TRUE(loaded);
  EXPECT_EQ((*loaded)[0].layout().base_pose.rest(), (*loaded)[1].layout().base_pose.rest());
  EXPECT_LT((*loaded)[1].byte_size(), 600u);
  for (const std::size_t i : {0u, 1u}) expect_same_poses((*loaded)[i], clips[i]);
}

TEST(clip_rest, clips_of_some_joints_go_on_sharing) {
  const Skeleton skeleton = wide_skeleton(kJoints);
  const ClipRest rest = clip_rest(skeleton, {}, {});
  const std::vector<Clip> clips = {compile_clip(small_animation(4, 7), rest, {}),
                                   compile_clip(small_animation(5, 1998), rest, {})};
  std::vector<std::uint32_t> even;
  for (std::uint32_t j = 0; j < kJoints; j += 2) even.push_back(j);
  const std::vector<Clip> kept = keep_joints(clips, even);
  EXPECT_EQ(kept[0].layout().base_pose.rest(), kept[1].layout().base_pose.rest());
  EXPECT_TRUE(kept[0].layout().base_pose.own().empty());  // joint 7 was not kept
  EXPECT_EQ(kept[1].layout().base_pose.own().size(), 3u);
  for (const std::size_t i : {0u, 1u}) expect_same_poses(kept[i], keep_joints(clips[i], even));
}

/// A block has table entries for all joints from its first to its last, so joints far apart get separate blocks.
TEST(clip_rest, joints_far_apart_take_no_tables_of_those_between) {
  const Skeleton skeleton = wide_skeleton(100'000);
  std::vector<BoneAnimation> bones;
  for (const std::uint32_t joint : {3u, 3u + kWidestGap, 4u + 2 * kWidestGap, 99'999u}) {
    bones.push_back(small_animation(joint, 0).bones[0]);
    bones.back().scale = {Interpolation::linear, {0, 1}, {{1, 1, 1}, {2, 3, 4}}};
  }
  const Animation animation = animation_of(bones);
  KeyTolerances coarse;
  coarse.bones.assign(bones.size(), {1e-3, 1e-3, 1e-3});
  for (const bool packed : {false, true}) {
    const Clip clip = compile_clip(animation, skeleton, {}, {}, {}, packed ? coarse : KeyTolerances());
    ASSERT_EQ(clip.layout().groups.size(), 1u);
    const std::vector<TrackBlock>& blocks = clip.layout().groups[0].blocks;
    ASSERT_EQ(blocks.size(), 6u);
    for (const std::size_t i : {0u, 3u}) EXPECT_EQ(blocks[i].targets, (std::vector<std::uint32_t>{3, 3 + kWidestGap}));
    EXPECT_EQ(!blocks[0].packed.empty(), packed);
    EXPECT_LT(clip.byte_size(), 10'000u);
    expect_same_poses(clip, clip);
    const std::vector<float> planes = planes_at(clip, 1.0);
    const std::size_t stride = PoseSpan::stride_for(100'000);
    for (const BoneAnimation& bone : bones) EXPECT_NEAR(planes[PoseSpan::rx * stride + bone.joint], 0.6f, 2e-3f);
  }
}

}  // namespace
}  // namespace sinew
