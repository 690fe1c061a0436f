// SPDX-License-Identifier: MIT
#include "runtime/clip/keep_joints.h"

#include <gtest/gtest.h>

#include <cmath>

#include "runtime/base/same_bits.h"
#include "runtime/clip/clip_layout.h"
#include "runtime/pose/sample_clip.h"
#include "tests/scenes/random_scene.h"
#include "tests/scenes/skeletons.h"
#include "tests/scenes/swinging.h"
#include "tests/support/fixed_random.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {
namespace {

struct Sample {
  std::vector<Transform> pose;
  std::vector<float> weights;
};

Sample sample(const Clip& clip, double time_s) {
  std::vector<float> memory(PoseSpan::floats_for(clip.joint_count()) + 16);
  auto* planes = reinterpret_cast<float*>((reinterpret_cast<std::uintptr_t>(memory.data()) + 63) / 64 * 64);
  const PoseSpan pose{planes, clip.joint_count(), PoseSpan::stride_for(clip.joint_count())};
  Sample out{{}, std::vector<float>(clip.weight_count())};
  const SampleClipJob job{.clip = &clip, .time_s = time_s, .pose = pose, .weights = out.weights};
  EXPECT_EQ(check(job), ErrorCode::ok);
  EXPECT_EQ(run(job), ErrorCode::ok);
  for (std::size_t j = 0; j < clip.joint_count(); ++j) out.pose.push_back(pose.get(j));
  return out;
}

/// Random joints, and all joints above them.
std::vector<std::uint32_t> some_joints(const Skeleton& skeleton, FixedRandom& random) {
  std::vector<bool> kept(skeleton.joint_count());
  for (std::size_t j = kept.size(); j-- > 0;) {
    kept[j] = kept[j] || random.below(3) == 0;
    if (kept[j] && skeleton.parents[j] != kNone) kept[skeleton.parents[j]] = true;
  }
  std::vector<std::uint32_t> joints;
  for (std::uint32_t j = 0; j < kept.size(); ++j)
    if (kept[j]) joints.push_back(j);
  return joints;
}

KeyTolerances coarse(const Animation& animation, std::size_t targets) {
  KeyTolerances rounding;
  rounding.bones.assign(animation.bones.size(), {1e-3, 1e-3, 1e-3});
  rounding.weights.assign(animation.weights.size(), std::vector<double>(targets, 1e-3));
  return rounding;
}

/// Expects that the kept joints have the bits of the whole clip at many times. Returns the number of packed blocks
/// with several lanes.
std::size_t expect_same_bits(const Clip& whole, std::span<const std::uint32_t> joints) {
  const Clip kept = keep_joints(whole, joints);
  EXPECT_EQ(kept.joint_count(), joints.size());
  EXPECT_EQ(kept.duration_s(), whole.duration_s());
  for (double time_s = -0.1; time_s < whole.duration_s() + 0.2; time_s += 0.037) {
    const Sample of_whole = sample(whole, time_s), of_kept = sample(kept, time_s);
    for (std::size_t k = 0; k < joints.size(); ++k)
      EXPECT_TRUE(same_bits(of_kept.pose[k], of_whole.pose[joints[k]])) << "joint " << joints[k] << " at " << time_s;
    EXPECT_TRUE(same_bits<float>(of_kept.weights, of_whole.weights));
  }
  std::size_t packed = 0;
  for (const TimeGroup& group : kept.layout().groups)
    for (const TrackBlock& block : group.blocks)
      packed += !block.packed.empty() && block.property != Property::weight && block.lane_count > 1;
  return packed;
}

TEST(keep_joints, N27_what_is_kept_has_the_bits_of_the_whole_clip) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    RandomSceneOptions options;
    options.joints = 8 + seed * 7;  // more lanes than one vector has
    const Scene scene = random_scene(seed, options);
    const std::vector<float> rest_weights = rest_weights_of(scene);
    FixedRandom random(seed);
    const std::vector<std::uint32_t> joints = some_joints(scene.skeleton, random);
    for (const bool rounded : {false, true}) {
      const KeyTolerances rounding = rounded ? coarse(scene.animations[0], options.targets) : KeyTolerances{};
      expect_same_bits(
          compile_clip(scene.animations[0], scene.skeleton, rest_weights, scene.first_weight, {}, rounding), joints);
    }
  }
}

TEST(keep_joints, N27_lanes_of_tracks_that_share_their_times_keep_their_bits) {
  const Skeleton skeleton = scenes::biped();
  Animation animation = scenes::swinging(skeleton, 30);
  // Some joints turn farther from key to key than others. The last one turns so far that its slerp needs a higher
  // power.
  for (const auto& [from_last, step_rad] : {std::pair{1, 1.0f}, {2, 0.28f}, {3, 0.27f}, {4, 0.29f}}) {
    QuatTrack& track = animation.bones[animation.bones.size() - static_cast<std::size_t>(from_last)].rotation;
    for (std::size_t k = 0; k < track.values.size(); ++k) {
      const float half_rad = step_rad * static_cast<float>(k);
      track.values[k] = quat_xyzw(std::sin(half_rad), 0.0f, 0.0f, std::cos(half_rad));
    }
  }
  const std::vector<std::uint32_t> no_weights = {0};
  std::size_t packed = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    FixedRandom random(seed + 3);
    const std::vector<std::uint32_t> joints = some_joints(skeleton, random);
    expect_same_bits(compile_clip(animation, skeleton, {}, no_weights), joints);
    packed += expect_same_bits(compile_clip(animation, skeleton, {}, no_weights, {}, coarse(animation, 0)), joints);
  }
  EXPECT_GE(packed, 8u);
}

TEST(keep_joints, tracks_of_other_joints_take_no_bytes) {
  const Scene scene = random_scene(3);
  const std::vector<std::uint32_t> root = {0};
  const Clip kept = keep_joints(scene.clips[0], root);
  const Clip::Counts counts = kept.counts(), whole = scene.clips[0].counts();
  EXPECT_LE(counts.translations + counts.rotations + counts.scales, 3u);
  EXPECT_EQ(counts.weights, whole.weights);
  EXPECT_LE(counts.time_groups, whole.time_groups);
  EXPECT_EQ(counts.time_groups, kept.layout().groups.size());
  EXPECT_LT(kept.byte_size(), scene.clips[0].byte_size());
}

TEST(keep_joints, all_of_them_are_the_whole) {
  const Scene scene = random_scene(5);
  std::vector<std::uint32_t> all;
  for (std::uint32_t j = 0; j < scene.skeleton.joint_count(); ++j) all.push_back(j);
  EXPECT_EQ(keep_joints(scene.skeleton, all).parents, scene.skeleton.parents);
  EXPECT_EQ(keep_joints(scene.skeleton, all).level_begin, scene.skeleton.level_begin);
  EXPECT_EQ(keep_joints(scene.clips[0], all).byte_size(), scene.clips[0].byte_size());
}

TEST(keep_joints, levels_that_nothing_is_left_of_are_gone) {
  const std::uint32_t joints[] = {0, 1};
  EXPECT_EQ(keep_joints(chain_skeleton(5), joints).level_begin, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(keep_joints, clips_keep_their_name_duration_and_certificate) {
  const Scene scene = random_scene(5);
  ClipCertificate certificate;
  certificate.measured_m = 0.25;
  const Clip whole = with_certificate(scene.clips[0], certificate);
  const std::uint32_t joints[] = {0};
  const Clip kept = keep_joints(whole, joints);
  EXPECT_EQ(kept.name(), whole.name());
  EXPECT_EQ(kept.duration_s(), whole.duration_s());
  EXPECT_EQ(kept.certificate(), whole.certificate());
}

TEST(keep_joints, a_skeleton_of_some_joints_passes_the_checks_of_any) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    Scene scene = random_scene(seed);
    FixedRandom random(seed);
    const std::vector<std::uint32_t> joints = some_joints(scene.skeleton, random);
    if (joints.empty()) continue;
    Scene bare;
    bare.skeleton = keep_joints(scene.skeleton, joints);
    finish_scene(bare);
    EXPECT_EQ(check(bare), ErrorCode::ok) << seed;
    for (std::size_t k = 0; k < joints.size(); ++k) {
      const std::uint32_t parent = scene.skeleton.parents[joints[k]];
      EXPECT_EQ(parent, bare.skeleton.parents[k] == kNone ? kNone : joints[bare.skeleton.parents[k]]);
    }
  }
}

}  // namespace
}  // namespace sinew::test
