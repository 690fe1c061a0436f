// SPDX-License-Identifier: MIT
// `sinew convert --fps`: which keys there are afterwards, and what they hold.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "importer/tool/convert/resample_clips.h"
#include "runtime/model/scene.h"
#include "tests/reference/sampling.h"

namespace sinew::tool {
namespace {

using testing::ElementsAre;

/// A scene with one clip, whose only joint is moved by what `animate` sets.
template <class Animate>
Animation resampled(double fps, const Animate& animate, double duration_s = 0.0) {
  Scene scene;
  Animation& animation = scene.animations.emplace_back();
  BoneAnimation& bone = animation.bones.emplace_back();
  animate(animation, bone);
  animation.duration_s = duration_s > 0.0 ? duration_s : bone.end_time();
  const auto out = resample_clips(scene.animations, fps);
  EXPECT_EQ(out.size(), 1u);
  EXPECT_EQ(out[0].duration_s, animation.duration_s);
  return out[0];
}

TEST(resample_clips, keys_are_both_ends_and_the_frames_between_them) {
  const Animation out = resampled(10.0, [](Animation&, BoneAnimation& bone) {
    bone.translation = {Interpolation::linear, {0.05f, 0.37f}, {{0, 0, 0}, {32, 0, 0}}};
    bone.scale = {Interpolation::linear, {0.2f, 0.4f}, {{1, 1, 1}, {2, 1, 1}}};
  });
  EXPECT_THAT(out.bones[0].translation.times_s, ElementsAre(0.05f, 0.1f, 0.2f, 0.3f, 0.37f));
  const float x[] = {0, 5, 15, 25, 32};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(out.bones[0].translation.values[i].x, x[i], 1e-5f) << i;
  EXPECT_THAT(out.bones[0].scale.times_s, ElementsAre(0.2f, 0.3f, 0.4f)) << "no key twice at an end";
}

TEST(resample_clips, a_curve_becomes_its_values_and_lines_between_them) {
  const Vec3Track curve{
      Interpolation::cubic_spline, {0.0f, 1.0f}, {{0, 0, 0}, {1, 0, 0}, {6, 0, 0}, {-3, 0, 0}, {2, 1, 0}, {0, 0, 0}}};
  const Animation out = resampled(4.0, [&](Animation&, BoneAnimation& bone) { bone.translation = curve; });
  const Vec3Track& track = out.bones[0].translation;
  EXPECT_EQ(track.interpolation, Interpolation::linear);
  ASSERT_EQ(track.values.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    const auto truth = reference::sample(curve, static_cast<double>(track.times_s[i]));
    EXPECT_NEAR(track.values[i].x, static_cast<double>(truth[0]), 1e-6) << i;
    EXPECT_NEAR(track.values[i].y, static_cast<double>(truth[1]), 1e-6) << i;
  }
}

TEST(resample_clips, rotations_follow_the_arc_and_are_unit) {
  const auto about_z = [](double angle) {
    return glm::quat(static_cast<float>(std::cos(angle / 2)), 0.0f, 0.0f, static_cast<float>(std::sin(angle / 2)));
  };
  const Animation out = resampled(3.0, [&](Animation&, BoneAnimation& bone) {
    bone.rotation = {Interpolation::linear, {0.0f, 1.0f}, {about_z(0.0), -about_z(2.4)}};
  });
  const QuatTrack& track = out.bones[0].rotation;
  ASSERT_EQ(track.values.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(std::abs(glm::dot(track.values[i], about_z(0.8 * static_cast<double>(i)))), 1.0, 1e-6) << i;
    EXPECT_NEAR(glm::length(track.values[i]), 1.0f, 1e-6f) << i;
  }
}

TEST(resample_clips, steps_and_single_keys_stay_as_they_are) {
  const Vec3Track steps{Interpolation::step, {0.0f, 0.33f, 0.5f}, {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}};
  const QuatTrack single{Interpolation::linear, {0.25f}, {glm::quat(0, 1, 0, 0)}};
  const Animation out = resampled(10.0, [&](Animation&, BoneAnimation& bone) {
    bone.translation = steps;
    bone.rotation = single;
  });
  EXPECT_EQ(out.bones[0].translation.interpolation, Interpolation::step);
  EXPECT_EQ(out.bones[0].translation.times_s, steps.times_s);
  EXPECT_EQ(out.bones[0].translation.values, steps.values);
  EXPECT_EQ(out.bones[0].rotation.times_s, single.times_s);
}

TEST(resample_clips, a_constant_track_keeps_one_key_or_two_where_the_clip_ends_with_it) {
  const Vec3Track still{Interpolation::linear, {0.0f, 1.0f}, {{3, 0, 0}, {3, 0, 0}}};
  const Animation alone = resampled(10.0, [&](Animation&, BoneAnimation& bone) { bone.translation = still; });
  EXPECT_THAT(alone.bones[0].translation.times_s, ElementsAre(0.0f, 1.0f)) << "or the clip would be shorter";
  const Animation among = resampled(10.0, [&](Animation&, BoneAnimation& bone) {
    bone.translation = still;
    bone.scale = {Interpolation::linear, {0.0f, 1.0f}, {{1, 1, 1}, {2, 2, 2}}};
  });
  EXPECT_THAT(among.bones[0].translation.times_s, ElementsAre(0.0f));
  EXPECT_EQ(among.bones[0].translation.values, std::vector<glm::vec3>({{3, 0, 0}}));
  EXPECT_EQ(among.bones[0].scale.times_s.size(), 11u);
  const Animation shorter = resampled(10.0, [&](Animation&, BoneAnimation& bone) {
    bone.translation = still;
    bone.scale = {Interpolation::linear, {0.0f, 0.5f}, {{1, 1, 1}, {2, 2, 2}}};
  });
  EXPECT_THAT(shorter.bones[0].translation.times_s, ElementsAre(0.0f, 1.0f)) << "the other track ends before the clip";
}

TEST(resample_clips, a_track_that_stands_still_for_a_while_is_not_constant) {
  for (const float middle : {0.0f, 1.0f}) {
    const Animation out = resampled(1.0, [&](Animation&, BoneAnimation& bone) {
      bone.translation = {Interpolation::linear, {0.0f, 1.0f, 2.0f}, {{0, 0, 0}, {middle, 0, 0}, {1, 0, 0}}};
    });
    EXPECT_EQ(out.bones[0].translation.key_count(), 3u) << middle;
  }
}

TEST(resample_clips, weights_that_last_let_constant_tracks_be_one_key) {
  const Vec3Track still{Interpolation::linear, {0.0f, 1.0f}, {{3, 0, 0}, {3, 0, 0}}};
  for (const float end_s : {1.0f, 0.5f}) {
    const Animation out = resampled(10.0, [&](Animation& animation, BoneAnimation& bone) {
      bone.translation = still;
      animation.weights.emplace_back().weights = {Interpolation::linear, {0.0f, end_s}, {0, 1}, 1};
    });
    EXPECT_EQ(out.bones[0].translation.times_s.size(), end_s == 1.0f ? 1u : 2u) << end_s;
  }
}

TEST(resample_clips, weights_are_resampled_target_by_target) {
  const Animation out = resampled(
      2.0,
      [](Animation& animation, BoneAnimation&) {
        WeightAnimation& weights = animation.weights.emplace_back();
        weights.weights = {Interpolation::linear, {0.0f, 1.0f}, {0, 1, 2, 5}, 2};
      },
      1.0);
  const WeightTrack& track = out.weights[0].weights;
  EXPECT_THAT(track.times_s, ElementsAre(0.0f, 0.5f, 1.0f));
  EXPECT_THAT(track.values, ElementsAre(0.0f, 1.0f, 1.0f, 3.0f, 2.0f, 5.0f));
  EXPECT_EQ(track.target_count, 2u);
}

TEST(resample_clips, curves_of_weights_become_their_values_and_lines_between_them) {
  const Animation out = resampled(
      2.0,
      [](Animation& animation, BoneAnimation&) {
        animation.weights.emplace_back().weights = {
            Interpolation::cubic_spline, {0.0f, 1.0f}, {0, 0, 0, 4, 8, 0, 0, 0, 1, 2, 0, 0}, 2};
      },
      1.0);
  const WeightTrack& track = out.weights[0].weights;
  EXPECT_EQ(track.interpolation, Interpolation::linear);
  EXPECT_THAT(track.times_s, ElementsAre(0.0f, 0.5f, 1.0f));
  EXPECT_THAT(track.values, ElementsAre(0.0f, 4.0f, 1.5f, 3.0f, 1.0f, 2.0f)) << "half of both ends and an eighth of 8";
}

/// In each clip one track of one joint moves, each time of another property. All other tracks rest.
TEST(resample_clips, of_every_joint_and_clip_each_constant_track_keeps_one_key) {
  const std::vector<float> ends{0.0f, 1.0f};
  BoneAnimation still;
  still.translation = {Interpolation::linear, ends, {{3, 0, 0}, {3, 0, 0}}};
  still.rotation = {Interpolation::linear, ends, {glm::quat(0, 1, 0, 0), glm::quat(0, 1, 0, 0)}};
  still.scale = {Interpolation::linear, ends, {{2, 2, 2}, {2, 2, 2}}};
  std::vector<Animation> clips(3, {"", 1.0, {still, still}, {}});
  clips[0].bones[0].translation.values[1].x = 5.0f;
  clips[1].bones[1].rotation.values[1] = glm::quat(1, 0, 0, 0);
  clips[2].bones[0].scale.values[1].y = 4.0f;
  const std::vector<Animation> out = resample_clips(clips, 2.0);
  ASSERT_EQ(out.size(), 3u);
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t b = 0; b < 2; ++b) {
      const BoneAnimation& bone = out[c].bones[b];
      EXPECT_EQ(bone.translation.key_count(), c == 0 && b == 0 ? 3u : 1u) << c << b;
      EXPECT_EQ(bone.rotation.key_count(), c == 1 && b == 1 ? 3u : 1u) << c << b;
      EXPECT_EQ(bone.scale.key_count(), c == 2 && b == 0 ? 3u : 1u) << c << b;
    }
}

}  // namespace
}  // namespace sinew::tool
