// SPDX-License-Identifier: MIT
#include "runtime/clip/clip.h"

#include <gtest/gtest.h>

#include <functional>

#include "runtime/clip/clip_layout.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using test::animation_of;

BoneAnimation bone_of(std::uint32_t joint, QuatTrack rotation, Vec3Track translation = {}, Vec3Track scale = {}) {
  BoneAnimation b;
  b.joint = joint;
  b.rotation = std::move(rotation);
  b.translation = std::move(translation);
  b.scale = std::move(scale);
  return b;
}

TEST(clip, P03_tracks_that_share_key_times_need_one_search) {
  test::FixedRandom random(1);
  const auto shared = test::random_times(random, 10);
  auto other = shared;
  other.back() += 0.5f;
  std::vector<BoneAnimation> bones;
  for (std::uint32_t j = 0; j < 8; ++j)
    bones.push_back(
        bone_of(j, test::random_rotations(random, Interpolation::linear, j < 7 ? shared : other),
                test::random_vectors(random, j % 2 ? Interpolation::step : Interpolation::cubic_spline, shared)));
  const Clip clip = test::clip_of(animation_of(std::move(bones)), test::chain_skeleton(8));
  EXPECT_EQ(clip.counts().time_groups, 2u);
  EXPECT_EQ(clip.counts().rotations, 8u);
  EXPECT_EQ(clip.counts().translations, 8u);
  EXPECT_EQ(clip.counts().folded, 0u);
}

TEST(clip, P02_constant_tracks_are_folded_into_the_base_pose) {
  const glm::quat q = quat_xyzw(0.6f, 0.0f, 0.0f, 0.8f), zero = quat_xyzw(0.0f, 0.0f, 0.0f, 0.0f);
  std::vector<BoneAnimation> bones;
  bones.push_back(
      bone_of(0, {Interpolation::linear, {0, 1, 2}, {q, q, q}}, {Interpolation::step, {0, 5}, {{1, 2, 3}, {1, 2, 3}}}));
  bones.push_back(bone_of(1, {Interpolation::linear, {4}, {q}}));
  bones.push_back(bone_of(2, {Interpolation::cubic_spline, {0, 1}, {q, q, zero, zero, q, q}}));
  const Clip clip = test::clip_of(animation_of(std::move(bones)), test::chain_skeleton(3));
  EXPECT_EQ(clip.counts().folded, 4u);
  EXPECT_EQ(clip.counts().rotations + clip.counts().translations, 0u);
  EXPECT_EQ(clip.counts().time_groups, 0u);
}

TEST(clip, P02_equal_keys_with_a_tangent_between_them_are_not_constant) {
  const glm::vec3 v(1, 2, 3), none(0), slope(0, 1, 0);
  for (const bool at_the_end : {false, true}) {
    BoneAnimation bone;
    bone.translation = {
        Interpolation::cubic_spline, {0, 1}, {none, v, at_the_end ? none : slope, at_the_end ? slope : none, v, none}};
    const glm::quat q(1, 0, 0, 0), no(0, 0, 0, 0), turn(0, 0, 1, 0);
    bone.rotation = {
        Interpolation::cubic_spline, {0, 1}, {no, q, at_the_end ? no : turn, at_the_end ? turn : no, q, no}};
    bone.scale = bone.translation;
    const Clip clip = test::clip_of(animation_of({bone}), test::chain_skeleton(1));
    EXPECT_EQ(clip.counts().folded, 0u);
    EXPECT_EQ(clip.counts().translations, 1u);
    EXPECT_EQ(clip.counts().rotations, 1u);
    EXPECT_EQ(clip.counts().scales, 1u);
  }
}

TEST(clip, P02_equal_weights_with_a_tangent_between_them_are_not_constant) {
  for (const bool at_the_end : {false, true})
    for (const std::size_t target : {0u, 1u}) {
      Animation animation{"test", 1.0, {}, {}};
      std::vector<float> rows = {7, 7, 0.5f, 0.25f, 0, 0,
                                 0, 0, 0.5f, 0.25f, 7, 7};  // the first and last tangents are unused
      rows[(at_the_end ? 6 : 4) + target] = 1.0f;
      animation.weights = {{0, {Interpolation::cubic_spline, {0, 1}, rows, 2}}};
      const float rest[] = {0.0f, 0.0f};
      const std::uint32_t first_weight[] = {0, 2};
      const Clip clip = compile_clip(animation, test::chain_skeleton(1), rest, first_weight);
      EXPECT_EQ(clip.counts().folded, 0u);
      EXPECT_EQ(clip.counts().weights, 2u);
    }
}

TEST(clip, P02_tangents_before_the_first_and_behind_the_last_key_mean_nothing) {
  const std::vector<float> rows = {7, 7, 0.5f, 0.25f, 0, 0, 0, 0, 0.5f, 0.25f, 7, 7};
  Animation animation{"test", 1.0, {}, {{0, {Interpolation::cubic_spline, {0, 1}, rows, 2}}}};
  const float rest[] = {0.0f, 0.0f};
  const std::uint32_t first_weight[] = {0, 2};
  const Clip clip = compile_clip(animation, test::chain_skeleton(1), rest, first_weight);
  EXPECT_EQ(clip.counts().folded, 2u);
  EXPECT_EQ(clip.layout().base_weights.all(), (std::vector{0.5f, 0.25f}));
}

TEST(clip, each_bone_is_rounded_by_its_own_tolerance_in_whatever_order_they_come) {
  test::FixedRandom random(4);
  const std::vector<float> times = test::random_times(random, 9);
  Animation animation{"test", 1.0, {}, {}};
  for (const std::uint32_t joint : {2u, 0u, 1u})
    animation.bones.push_back(bone_of(joint, test::random_rotations(random, Interpolation::linear, times)));
  for (std::size_t rounded = 0; rounded < 3; ++rounded) {
    KeyTolerances rounding;
    rounding.bones.resize(3);
    rounding.bones[rounded].rotation = 1e-2;
    const Clip clip = compile_clip(animation, test::chain_skeleton(3), {}, {}, {}, rounding);
    for (const TrackBlock& block : clip.layout().groups.at(0).blocks)
      for (const std::uint32_t joint : block.targets)
        EXPECT_EQ(!block.packed.empty(), joint == animation.bones[rounded].joint) << joint;
  }
}

TEST(clip, duration_is_that_of_the_animation) {
  BoneAnimation bone = bone_of(0, {}, {Interpolation::linear, {3, 7}, {{0, 0, 0}, {1, 0, 0}}});
  const Clip clip = test::clip_of(animation_of({bone}), test::chain_skeleton(2));
  EXPECT_EQ(clip.duration_s(), 7.0);
  EXPECT_EQ(clip.joint_count(), 2u);
  EXPECT_EQ(clip.name(), "test");
}

TEST(clip, bytes_are_close_to_those_of_the_keys) {
  test::FixedRandom random(2);
  const auto times = test::random_times(random, 200);
  std::vector<BoneAnimation> bones;
  std::size_t source = times.size() * sizeof(float);
  for (std::uint32_t j = 0; j < 50; ++j) {
    bones.push_back(bone_of(j, test::random_rotations(random, Interpolation::linear, times),
                            test::random_vectors(random, Interpolation::linear, times)));
    source += times.size() * 7 * sizeof(float);
  }
  const Clip clip = test::clip_of(animation_of(std::move(bones)), test::chain_skeleton(50));
  EXPECT_LE(clip.byte_size(), source * 5 / 4);
}

TEST(clip, bytes_count_every_array) {
  const Vec3Track moved{Interpolation::linear, {0, 1}, {{0, 0, 0}, {1, 0, 0}}};
  const ClipLayout layout = test::clip_of(animation_of({bone_of(0, {}, moved)}), test::chain_skeleton(2)).layout();
  const TrackBlock& first = layout.groups[0].blocks[0];
  const auto more = [&](const std::function<void(ClipLayout&)>& change) {
    ClipLayout changed = layout;
    change(changed);
    return clip_of(changed).byte_size() - clip_of(layout).byte_size();
  };
  const auto block = [](ClipLayout& l) -> TrackBlock& { return l.groups[0].blocks[0]; };
  EXPECT_EQ(more([&](ClipLayout& l) { block(l).targets.push_back(1); }), 4u);
  EXPECT_EQ(more([&](ClipLayout& l) { block(l).places.lane_of.push_back(1); }), 4u);
  EXPECT_EQ(more([&](ClipLayout& l) { block(l).places.lanes_before.push_back(1); }), 4u);
  EXPECT_EQ(more([&](ClipLayout& l) { block(l).rows.assign(block(l).rows.size() + 3, 0.0f); }), 12u);
  EXPECT_EQ(more([&](ClipLayout& l) { l.groups[0].blocks.push_back(block(l)); }),
            first.rows.size() * 4 + 4 + first.places.byte_size());
  SharedArray<float> times;
  times.assign(3, 0.0f);
  times.own()[2] = 1.0f;
  const KeyTimes longer(times);
  EXPECT_EQ(more([&](ClipLayout& l) { l.groups[0].times = longer; }),
            longer.byte_size() - layout.groups[0].times.byte_size());
  EXPECT_EQ(more([&](ClipLayout& l) { l.groups.push_back({longer, {}}); }), longer.byte_size());
}

TEST(clip, G20_of_two_tracks_for_one_property_the_last_counts) {
  BoneAnimation first = bone_of(0, {}, {Interpolation::linear, {0, 1}, {{1, 1, 1}, {2, 2, 2}}});
  BoneAnimation second = bone_of(0, {}, {Interpolation::linear, {0, 2}, {{5, 5, 5}, {6, 6, 6}}});
  const Clip clip = test::clip_of(animation_of({first, second}), test::chain_skeleton(1));
  EXPECT_EQ(clip.counts().translations, 1u);
  EXPECT_EQ(clip.layout().groups.front().times.times_s().back(), 2.0f);
}

TEST(clip, G20_of_two_tracks_for_one_set_of_weights_the_last_counts) {
  const WeightTrack track{Interpolation::linear, {0, 1}, {1, 2}, 1}, later{Interpolation::linear, {0, 2}, {5, 6}, 1};
  const float rest[] = {0.0f, 0.0f};
  const std::uint32_t first_weight[] = {0, 2};
  const Clip clip = compile_clip({"test", 2.0, {}, {{0, track, 1}, {0, track, 0}, {0, later, 1}}},
                                 test::chain_skeleton(1), rest, first_weight);
  EXPECT_EQ(clip.counts().weights, 2u);
  for (const TimeGroup& group : clip.layout().groups)
    for (const TrackBlock& block : group.blocks)
      EXPECT_EQ(group.times.times_s().back(), block.targets.at(0) == 1 ? 2.0f : 1.0f);
}

TEST(clip, moved_clips_keep_their_contents) {
  Clip a = test::clip_of(animation_of({}), test::chain_skeleton(3));
  const Clip b = std::move(a);
  EXPECT_EQ(b.joint_count(), 3u);
}

TEST(clip, tracks_of_one_key_are_folded_whatever_their_interpolation) {
  for (const Interpolation kind :
       {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline, Interpolation::squad}) {
    BoneAnimation bone;
    test::FixedRandom random(31);
    bone.translation = test::random_vectors(random, kind, {0.5f});
    bone.scale = test::random_vectors(random, kind, {0.5f});
    bone.rotation = {
        kind, {0.5f}, std::vector<glm::quat>(test::value_count(kind, 1), quat_xyzw(0.0f, 1.0f, 0.0f, 0.0f))};
    const Clip clip = test::clip_of(animation_of({bone}), test::chain_skeleton(1));
    EXPECT_EQ(clip.counts().folded, 3u) << static_cast<int>(kind);
    EXPECT_EQ(clip.counts().time_groups, 0u);
  }
}

}  // namespace
}  // namespace sinew
