// SPDX-License-Identifier: MIT
#include "runtime/clip/unpack_clip.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/clip/clip_file.h"
#include "runtime/clip/clip_layout.h"
#include "runtime/pose/sample_clip.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {
namespace {

constexpr double kTolerance = 1e-3;
constexpr double kRoundingOfPoses = 1e-6;
/// Rounded keys are not unit, which changes rotations between keys by up to this part of the tolerance.
constexpr double kOfTolerance = 0.25;

std::size_t packed_blocks(const Clip& clip) {
  std::size_t count = 0;
  for (const TimeGroup& group : clip.layout().groups)
    count += static_cast<std::size_t>(std::count_if(group.blocks.begin(), group.blocks.end(),
                                                    [](const TrackBlock& block) { return !block.packed.empty(); }));
  return count;
}

struct Sample {
  PoseBuffer pose;
  std::vector<float> weights;

  Sample(const Clip& clip, double time_s) : pose(clip.joint_count()), weights(clip.weight_count()) {
    EXPECT_EQ(run(SampleClipJob{.clip = &clip, .time_s = time_s, .pose = pose.span(), .weights = weights}),
              ErrorCode::ok);
  }
};

void expect_same_pose(const Clip& clip, const Clip& full, double time_s, double rotations_within_rad) {
  Sample expected(clip, time_s), found(full, time_s);
  for (std::size_t j = 0; j < clip.joint_count(); ++j) {
    const Transform e = expected.pose.span().get(j), f = found.pose.span().get(j);
    EXPECT_TRUE(is_near(Vec3<double>(f.translation), Vec3<double>(e.translation), kRoundingOfPoses))
        << j << " at " << time_s;
    EXPECT_TRUE(is_near(Vec3<double>(f.scale), Vec3<double>(e.scale), kRoundingOfPoses)) << j << " at " << time_s;
    EXPECT_TRUE(same_rotation(f.rotation, quat_cast<double>(e.rotation), rotations_within_rad))
        << j << " at " << time_s;
  }
  for (std::size_t w = 0; w < found.weights.size(); ++w) EXPECT_NEAR(found.weights[w], expected.weights[w], 1e-6f);
}

void expect_same_motion(const Clip& clip, double from_s, double to_s, FixedRandom& random) {
  const Clip full = unpacked(clip);
  EXPECT_GT(packed_blocks(clip), 0u);
  EXPECT_EQ(packed_blocks(full), 0u);
  EXPECT_EQ(full.counts().rotations, clip.counts().rotations);
  for (int i = 0; i < 60; ++i)
    expect_same_pose(clip, full, random.in(from_s - 0.1, to_s + 0.1), kOfTolerance * kTolerance);
}

/// Swinging joints, some with step interpolation. Each has its own key times, unless `shared_times`. Signs of
/// quaternions are random.
Animation swings(FixedRandom& random, std::uint32_t joints, bool shared_times = false) {
  const std::vector<float> first = random_times(random, 20),
                           times[] = {first, shared_times ? first : random_times(random, 11)};
  std::vector<BoneAnimation> bones;
  for (std::uint32_t j = 0; j < joints; j += 1 + random.below(2)) {
    BoneAnimation bone;
    bone.joint = j;
    bone.rotation = {j % 5 == 0 ? Interpolation::step : Interpolation::linear, times[j % 2], {}};
    Quat<double> q = random.rotation<double>();
    for (std::size_t k = 0; k < bone.rotation.times_s.size(); ++k) {
      bone.rotation.values.push_back(quat_cast<float>(random.below(2) ? q : -q));
      q = q * random.rotation_by<double>(random.in(0, 1.5));
    }
    bone.translation = random_vectors(random, Interpolation::linear, times[(j + 1) % 2]);
    bone.scale = random_vectors(random, Interpolation::linear, times[j % 2]);
    bones.push_back(std::move(bone));
  }
  return animation_of(std::move(bones));
}

KeyTolerances coarse(const Animation& animation) {
  KeyTolerances rounding;
  rounding.bones.assign(animation.bones.size(), {kTolerance, kTolerance, kTolerance});
  for (const WeightAnimation& animated : animation.weights)
    rounding.weights.emplace_back(animated.weights.target_count, kTolerance);
  return rounding;
}

TEST(unpack_clip, G01_moves_as_before_on_the_short_arc) {
  FixedRandom random(23);
  for (const std::uint32_t joints : {1u, 15u, 40u}) {
    Animation animation = swings(random, joints);
    const std::vector<float> rest(7, 0.0f);
    const std::vector<std::uint32_t> first{0, 7};
    animation.weights.push_back({0, random_weights(random, Interpolation::linear, random_times(random, 9), 7), 0});
    expect_same_motion(compile_clip(animation, chain_skeleton(joints), rest, first, {}, coarse(animation)), 0.0,
                       animation.duration_s, random);
  }
}

TEST(unpack_clip, G06_has_the_packed_keys_at_their_times) {
  FixedRandom random(22);
  const Animation animation = swings(random, 30, true);
  const Clip clip = compile_clip(animation, chain_skeleton(30), {}, {}, {}, coarse(animation)), full = unpacked(clip);
  ASSERT_EQ(clip.counts().time_groups, 1u);
  for (const float key_s : clip.layout().groups[0].times.times_s())
    expect_same_pose(clip, full, static_cast<double>(key_s), kRoundingOfPoses);
}

TEST(unpack_clip, more_lanes_than_packed_rows_have_fit) {
  FixedRandom random(24);
  const std::uint32_t joints = 2500;
  const Animation animation = swings(random, joints, true);  // of one list of times
  expect_same_motion(compile_clip(animation, chain_skeleton(joints), {}, {}, {}, coarse(animation)), 0.3, 0.7, random);
}

TEST(unpack_clip, lanes_of_every_packed_block_reach_their_joints) {
  FixedRandom random(27);
  const std::uint32_t joints = 2500;
  const Animation animation = swings(random, joints, true);  // of one list of times
  const Clip clip = compile_clip(animation, chain_skeleton(joints), {}, {}, {}, coarse(animation)),
             exact = compile_clip(animation, chain_skeleton(joints), {}, {});
  PoseBuffer rounded(joints), pose(joints);
  EXPECT_EQ(run(SampleClipJob{.clip = &clip, .time_s = 0.4, .pose = rounded.span(), .weights = {}}), ErrorCode::ok);
  EXPECT_EQ(run(SampleClipJob{.clip = &exact, .time_s = 0.4, .pose = pose.span(), .weights = {}}), ErrorCode::ok);
  for (std::uint32_t j = 0; j < joints; ++j)
    ASSERT_LT(angle_between(rounded.span().get(j).rotation, pose.span().get(j).rotation), 0.1) << j;
}

TEST(unpack_clip, keeps_what_was_never_rounded_to_the_last_bit) {
  FixedRandom random(25);
  const Animation animation = swings(random, 12);
  const Clip clip = compile_clip(animation, chain_skeleton(12), {}, {}), same = unpacked(clip);
  EXPECT_EQ(save_clips(std::vector<const Clip*>{&same}), save_clips(std::vector<const Clip*>{&clip}));
}

TEST(unpack_clip, keeps_the_certificate_and_takes_the_memory_of_floats) {
  FixedRandom random(26);
  const Animation animation = swings(random, 12);
  const Clip clip = with_certificate(compile_clip(animation, chain_skeleton(12), {}, {}, {}, coarse(animation)),
                                     {.asked_m = 0.5, .measured_m = 0.25});
  const Clip full = unpacked(clip);
  EXPECT_EQ(full.certificate(), clip.certificate());
  EXPECT_EQ(full.byte_size(), compile_clip(animation, chain_skeleton(12), {}, {}).byte_size());
}

}  // namespace
}  // namespace sinew::test
