// SPDX-License-Identifier: MIT
#include "runtime/pose/sample_clip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <tuple>

#include "runtime/animation/track_sample.h"
#include "runtime/base/same_bits.h"
#include "tests/reference/sampling.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/near.h"
#include "tests/support/simd_targets.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

constexpr Interpolation kAll[] = {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline,
                                  Interpolation::squad};

Interpolation vector_kind(Interpolation i) { return i == Interpolation::squad ? Interpolation::linear : i; }

/// A clip, its animation and room for a pose.
struct Player {
  Animation animation;
  Skeleton skeleton;
  Clip clip;
  test::PoseBuffer pose;

  Player(std::vector<BoneAnimation> bones, std::uint32_t joints)
      : animation(test::animation_of(std::move(bones))),
        skeleton(test::chain_skeleton(joints)),
        clip(test::clip_of(animation, skeleton)),
        pose(joints) {}

  SampleClipJob job(double time_s) { return {.clip = &clip, .time_s = time_s, .pose = pose.span(), .weights = {}}; }
  Transform at(double time_s, std::size_t joint = 0) {
    EXPECT_EQ(check(job(time_s)), ErrorCode::ok);
    EXPECT_EQ(run(job(time_s)), ErrorCode::ok);
    return pose.span().get(joint);
  }
};

Player one(QuatTrack track) {
  BoneAnimation bone;
  bone.rotation = std::move(track);
  return {{bone}, 1};
}

Player one(Vec3Track track) {
  BoneAnimation bone;
  bone.translation = std::move(track);
  return {{bone}, 1};
}

/// `joints` joints that are animated in all ways, in few time groups.
Player crowded(std::uint32_t joints, std::uint64_t seed) {
  test::FixedRandom random(seed);
  std::vector<std::vector<float>> times;
  for (int i = 0; i < 5; ++i) times.push_back(test::random_times(random, 12, i == 4 ? 3 : 0));
  std::vector<BoneAnimation> bones;
  for (std::uint32_t j = 0; j < joints; ++j) {
    BoneAnimation bone;
    bone.joint = j;
    if (random.below(8) != 0)
      bone.rotation = test::random_rotations(random, kAll[random.below(4)], times[random.below(5)]);
    if (random.below(8) != 0)
      bone.translation = test::random_vectors(random, kAll[random.below(3)], times[random.below(5)]);
    if (random.below(8) != 0) bone.scale = test::random_vectors(random, kAll[random.below(3)], times[random.below(5)]);
    bones.push_back(std::move(bone));
  }
  return {std::move(bones), joints};
}

TEST(sample_clip, rejects_buffers_of_other_sizes) {
  Player player = one(test::track_of<glm::vec3>(Interpolation::linear, {0, 1}, {{0, 0, 0}, {1, 0, 0}}));
  float weight = 0;
  const struct {
    const char* what;
    std::function<void(SampleClipJob&)> damage;
  } cases[] = {
      {"no clip", [](SampleClipJob& j) { j.clip = nullptr; }},
      {"no pose", [](SampleClipJob& j) { j.pose.planes = nullptr; }},
      {"more joints", [](SampleClipJob& j) { j.pose.joint_count = 2; }},
      {"other stride", [](SampleClipJob& j) { j.pose.stride = 8; }},
      {"weights that the clip has not",
       [&](SampleClipJob& j) {
         j.weights = {&weight, 1};
       }},
  };
  EXPECT_EQ(check(player.job(0)), ErrorCode::ok);
  for (const auto& c : cases) {
    auto job = player.job(0);
    c.damage(job);
    EXPECT_EQ(check(job), ErrorCode::size_mismatch) << c.what;
  }
}

TEST(sample_clip, no_joints_and_no_tracks_is_no_work) {
  Player empty({}, 0);
  EXPECT_EQ(check(empty.job(1)), ErrorCode::ok);
  EXPECT_EQ(run(empty.job(1)), ErrorCode::ok);
}

TEST(sample_clip, hand_computed_values_halfway) {
  const float h = std::sqrt(0.5f);
  EXPECT_TRUE(test::is_near(
      one(test::track_of<glm::vec3>(Interpolation::linear, {1, 3}, {{0, 2, 4}, {2, 4, 8}})).at(2).translation,
      {1, 3, 6}, 1e-6));
  Player quarter = one({Interpolation::linear, {0, 1}, {quat_identity<float>(), quat_xyzw(0.0f, 0.0f, h, h)}});
  EXPECT_TRUE(
      test::same_rotation(quarter.at(0.5).rotation, quat_xyzw(0.0, 0.0, std::sin(M_PI / 8), std::cos(M_PI / 8)), 1e-7));
  Player cubic =
      one({Interpolation::cubic_spline, {1, 3}, {{99, 0, 0}, {1, 0, 0}, {4, 0, 0}, {8, 0, 0}, {5, 0, 0}, {77, 0, 0}}});
  EXPECT_FLOAT_EQ(cubic.at(2).translation.x, 2.0f);
}

TEST(sample_clip, G01_G02_N01_N02_rotations_of_any_spacing_follow_the_short_arc) {
  test::FixedRandom random(1);
  for (const double angle : {0.0, 1e-12, 1e-7, 1e-5, 1e-4, 1e-3, 0.1, 1.0, 2.0, 3.0, 3.14, 3.1415926, 3.3, 5.0, 6.28})
    for (int i = 0; i < 20; ++i) {
      const Quat<double> q = random.rotation<double>(), r = q * random.rotation_by<double>(angle);
      const QuatTrack track{Interpolation::linear, {0, 1}, {quat_cast<float>(q), quat_cast<float>(i % 2 ? r : -r)}};
      // the sign at exactly half a turn is that of the float keys, decided in double
      const double t = random.unit();
      const auto expected = reference::quat_of(reference::unit(reference::sample(track, t)));
      EXPECT_TRUE(test::same_rotation(one(track).at(t).rotation, expected, 4e-7)) << angle << " at " << t;
    }
}

TEST(sample_clip, N04_P04_linear_rotations_turn_at_constant_speed) {
  const float h = std::sqrt(0.5f);
  Player player = one({Interpolation::linear, {0, 1}, {quat_identity<float>(), quat_xyzw(h, 0.0f, 0.0f, h)}});
  for (int i = 1; i < 64; ++i) {
    const auto q = player.at(i / 64.0).rotation;
    EXPECT_NEAR(2 * std::atan2(double(q.x), double(q.w)), i / 64.0 * M_PI / 2, 2e-7);
  }
}

TEST(sample_clip, G06_keys_come_out_bit_for_bit) {
  test::FixedRandom random(6);
  for (const auto interpolation : kAll) {
    const auto times = test::random_times(random, 20);
    const bool cubic = interpolation == Interpolation::cubic_spline;
    const QuatTrack rotation = test::random_rotations(random, interpolation, times);
    const Vec3Track vectors = test::random_vectors(random, vector_kind(interpolation), times);
    Player q = one(rotation), v = one(vectors);
    for (std::size_t k = 0; k < times.size(); ++k) {
      EXPECT_EQ(q.at(double(times[k])).rotation, rotation.values[cubic ? 3 * k + 1 : k]);
      EXPECT_EQ(v.at(double(times[k])).translation, vectors.values[cubic ? 3 * k + 1 : k]);
    }
  }
}

TEST(sample_clip, G03_G05_G07_G10_G13_every_joint_agrees_with_its_bone_animation) {
  // 200 joints: more than one chunk of lanes. Times before, on, between and after the keys.
  Player player = crowded(200, 4);
  test::FixedRandom random(5);
  for (int i = 0; i < 300; ++i) {
    const double t = i < 10 ? double(player.animation.bones[static_cast<std::size_t>(i)].end_time())
                            : random.in(-0.2, player.clip.duration_s() + 0.2);
    ASSERT_EQ(run(player.job(t)), ErrorCode::ok);
    for (const BoneAnimation& bone : player.animation.bones) {
      const Transformd truth = bone.interpolate<double>(t);
      const Transform found = player.pose.span().get(bone.joint);
      EXPECT_TRUE(test::is_near(Vec3<double>(found.translation), truth.translation, 2e-6)) << bone.joint << " at " << t;
      EXPECT_TRUE(test::is_near(Vec3<double>(found.scale), truth.scale, 2e-6)) << bone.joint << " at " << t;
      // Squad's error grows with its arcs, and random cubic rotations pass near zero, where any direction is far.
      const double tolerance = bone.rotation.interpolation == Interpolation::linear ? 4e-7
                               : bone.rotation.interpolation == Interpolation::step ? 0
                                                                                    : 3e-5;
      EXPECT_LE(test::angle_between(found.rotation, truth.rotation), tolerance) << bone.joint << " at " << t;
    }
  }
}

TEST(sample_clip, G22_joints_without_tracks_among_animated_ones_keep_their_rest_pose) {
  constexpr std::uint32_t kJoints = 40;
  test::FixedRandom random(7);
  for (std::uint32_t round = 0; round < 100; ++round) {
    std::vector<BoneAnimation> bones;
    std::vector<float> x(kJoints, 0.0f);
    for (std::uint32_t j = 0; j < kJoints; ++j) {
      const bool rests = round < kJoints ? j == round : random.below(1 + round % 12) != 0;  // one joint, some, most
      if (rests) continue;
      x[j] = static_cast<float>(1 + j);
      BoneAnimation bone;
      bone.joint = j;
      bone.translation = test::track_of<glm::vec3>(Interpolation::linear, {0, 2}, {{0, 0, 0}, {2 * x[j], 0, 0}});
      bones.push_back(bone);
    }
    Player player(std::move(bones), kJoints);
    for (const std::int64_t target : test::simd_targets()) {
      const test::OnlyTarget only(target);
      EXPECT_EQ(run(player.job(1.0)), ErrorCode::ok);
      for (std::uint32_t j = 0; j < kJoints; ++j)
        ASSERT_EQ(player.pose.span().get(j).translation.x, x[j]) << "joint " << j << ", " << test::simd_name(target);
    }
  }
}

TEST(sample_clip, G08_one_key_is_a_constant_and_G10_times_outside_clamp) {
  Player single = one(test::track_of<glm::vec3>(Interpolation::linear, {2}, {{5, 6, 7}}));
  for (const double t : {-1e30, 0.0, 2.0, 1e30}) EXPECT_EQ(single.at(t).translation, glm::vec3(5, 6, 7));
  Player two = one(test::track_of<glm::vec3>(Interpolation::linear, {1, 2}, {{1, 0, 0}, {2, 0, 0}}));
  EXPECT_EQ(two.at(-5).translation.x, 1);
  EXPECT_EQ(two.at(1e30).translation.x, 2);
  EXPECT_EQ(two.at(std::nan("")).translation.x, 1);
}

TEST(sample_clip, G07_step_switches_on_the_key_and_not_before) {
  Player player = one(test::track_of<glm::vec3>(Interpolation::step, {0, 1, 2}, {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}}));
  EXPECT_EQ(player.at(std::nextafter(1.0, 0.0)).translation.x, 1);
  EXPECT_EQ(player.at(1.0).translation.x, 2);
}

TEST(sample_clip, G13_jumps_divide_by_no_empty_interval) {
  Player player = one(
      test::track_of<glm::vec3>(Interpolation::linear, {0, 1, 1, 2}, {{0, 0, 0}, {10, 0, 0}, {20, 0, 0}, {30, 0, 0}}));
  EXPECT_NEAR(player.at(std::nextafter(1.0, 0.0)).translation.x, 10, 1e-5);
  EXPECT_EQ(player.at(1.0).translation.x, 20);
  EXPECT_NEAR(player.at(1.5).translation.x, 25, 1e-5);
}

TEST(sample_clip, G22_what_the_clip_does_not_animate_returns_to_rest) {
  test::FixedRandom random(22);
  BoneAnimation bone;
  bone.joint = 1;
  bone.translation = test::random_vectors(random, Interpolation::linear, {0, 1});
  Skeleton skeleton = test::chain_skeleton(3);
  for (Transform& t : skeleton.rest) t = random.transform();
  const Clip clip = test::clip_of(test::animation_of({bone}), skeleton);
  test::PoseBuffer pose(3);
  for (std::size_t j = 0; j < 3; ++j) pose.span().set(j, random.transform());  // left over from another clip
  EXPECT_EQ(run(SampleClipJob{.clip = &clip, .time_s = 0.5, .pose = pose.span(), .weights = {}}), ErrorCode::ok);
  EXPECT_EQ(pose.span().get(0), skeleton.rest[0]);
  EXPECT_EQ(pose.span().get(2), skeleton.rest[2]);
  EXPECT_EQ(pose.span().get(1).rotation, skeleton.rest[1].rotation);
  EXPECT_EQ(pose.span().get(1).scale, skeleton.rest[1].scale);
}

TEST(sample_clip, P02_folded_tracks_give_their_constant_at_all_times) {
  const glm::quat q = quat_xyzw(0.6f, 0.0f, 0.0f, 0.8f);
  Player player = one({Interpolation::linear, {0, 1, 2}, {q, q, q}});
  EXPECT_EQ(player.clip.counts().folded, 1u);
  for (const double t : {-1.0, 0.0, 0.7, 5.0}) EXPECT_EQ(player.at(t).rotation, q);
}

TEST(sample_clip, N26_only_keys_have_components_whose_square_is_no_normal_number) {
  const glm::quat tiny = quat_xyzw(0.6f, 9e-19f, -4e-36f, 0.8f), found = quat_xyzw(0.6f, 0.0f, 0.0f, 0.8f);
  Player player = one({Interpolation::linear, {0, 1}, {tiny, tiny}});
  EXPECT_TRUE(same_bits(player.at(0.0).rotation, tiny))
      << "a key is returned as it is stored, also of a track that never changes";
  EXPECT_TRUE(same_bits(player.at(1.0).rotation, tiny));
  const glm::quat between = player.at(0.5).rotation;
  EXPECT_EQ(between.y, 0.0f);
  EXPECT_EQ(between.z, 0.0f);
  EXPECT_TRUE(test::same_rotation(between, quat_cast<double>(found), 2e-7));
  EXPECT_TRUE(same_bits(one({Interpolation::step, {0, 1}, {tiny, tiny}}).at(0.5).rotation, tiny));
  Skeleton skeleton = test::chain_skeleton(1);
  skeleton.rest[0].rotation = tiny;
  const Clip clip = test::clip_of({}, skeleton);
  test::PoseBuffer pose(1);
  EXPECT_EQ(run(SampleClipJob{.clip = &clip, .time_s = 0.0, .pose = pose.span(), .weights = {}}), ErrorCode::ok);
  EXPECT_EQ(pose.span().get(0).rotation, found);
}

TEST(sample_clip, G19_G43_weights_of_all_instances_and_modes) {
  test::FixedRandom random(19);
  const std::vector<float> rest{9, 8, 7, 6, 5, 4, 3};
  const std::vector<std::uint32_t> first{0, 2, 5, 7};
  const Skeleton skeleton = test::chain_skeleton(1);
  for (const auto interpolation : {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline}) {
    Animation animation;
    animation.weights.push_back({1, test::random_weights(random, interpolation, {0, 1, 1.5f, 4}, 3)});
    animation.weights.push_back({2, {Interpolation::linear, {0, 1}, {1, 2, 1, 2}, 2}});
    const Clip clip = compile_clip(animation, skeleton, rest, first);
    EXPECT_EQ(clip.counts().weights, 3u);
    EXPECT_EQ(clip.counts().folded, 2u);
    test::PoseBuffer pose(1);
    std::vector<float> found(7);
    for (const double t : {-1.0, 0.0, 0.3, 1.0, 1.2, 3.0, 4.0, 5.0}) {
      const SampleClipJob job{.clip = &clip, .time_s = t, .pose = pose.span(), .weights = found};
      ASSERT_EQ(run(job), ErrorCode::ok);
      const WeightTrack& track = animation.weights[0].weights;
      for (std::size_t i = 0; i < 3; ++i) {
        // one target of the track, as a track of its own
        Vec3Track alone{interpolation, track.times_s, {}};
        for (std::size_t row = 0; row < track.values.size() / 3; ++row)
          alone.values.emplace_back(track.values[3 * row + i]);
        EXPECT_NEAR(double(found[2 + i]), double(reference::sample(alone, t)[0]), 1e-6) << t;
      }
      EXPECT_EQ((std::vector<float>{found[0], found[1], found[5], found[6]}), (std::vector<float>{9, 8, 1, 2}));
    }
  }
}

TEST(sample_clip, weights_that_are_not_wanted_are_left_out) {
  Animation animation;
  animation.weights.push_back({0, {Interpolation::linear, {0, 1}, {0, 1}, 1}});
  const Clip clip =
      compile_clip(animation, test::chain_skeleton(1), std::vector<float>{0}, std::vector<std::uint32_t>{0, 1});
  test::PoseBuffer pose(1);
  const SampleClipJob job{.clip = &clip, .time_s = 0.5, .pose = pose.span(), .weights = {}};
  EXPECT_EQ(check(job), ErrorCode::ok);
  EXPECT_EQ(run(job), ErrorCode::ok);
}

TEST(sample_clip, N24_hours_into_a_clip_fractions_keep_their_digits) {
  Player player = one(test::track_of<glm::vec3>(Interpolation::linear, {36000, 36001}, {{0, 0, 0}, {1, 0, 0}}));
  EXPECT_NEAR(double(player.at(36000.0001).translation.x), 1e-4, 1e-10);
}

TEST(sample_clip, N29_rotations_are_unit_however_the_keys_were_rounded) {
  test::FixedRandom random(29);
  QuatTrack track{Interpolation::linear, {}, {}};
  for (int k = 0; k < 100; ++k) {
    track.times_s.push_back(static_cast<float>(k));
    track.values.push_back(random.rotation() * static_cast<float>(random.in(0.999, 1.001)));
  }
  Player player = one(track);
  for (int i = 0; i < 2000; ++i) {
    const double t = random.in(0, 99);
    if (t == std::floor(t)) continue;  // keys come out as stored
    EXPECT_NEAR(safe_length(quat_cast<double>(player.at(t).rotation)), 1, 4 * test::kEps);
  }
}

TEST(sample_clip, G14_zero_length_keys_give_no_NaN_in_cubic_rotations) {
  const glm::quat zero = quat_xyzw(0.0f, 0.0f, 0.0f, 0.0f), q = quat_identity<float>();
  Player player = one({Interpolation::cubic_spline, {0, 1}, {zero, q, zero, zero, -q, zero}});
  EXPECT_TRUE(test::same_rotation(player.at(0.5).rotation, q, 1e-6));
}

TEST(sample_clip, G05_a_cubic_rotation_through_zero_falls_back_to_the_nearer_of_two_different_keys) {
  // Tangents for which the sum is exactly zero a quarter of the way: 54 q0 + 10 q1 - 3 in = 0 (in 64ths), and three
  // quarters of the way by symmetry. The keys' lengths make all products exact.
  const glm::quat zero = quat_xyzw(0.0f, 0.0f, 0.0f, 0.0f);
  const glm::quat q0 = quat_xyzw(0.0f, 0.75f, 0.0f, 0.375f), q1 = quat_xyzw(0.75f, 0.0f, 0.0f, 0.375f);
  const glm::quat in = quat_xyzw(2.5f, 13.5f, 0.0f, 8.0f), out = quat_xyzw(-13.5f, -2.5f, 0.0f, -8.0f);
  const QuatTrack early{Interpolation::cubic_spline, {0, 1}, {zero, q0, zero, in, q1, zero}};
  const QuatTrack late{Interpolation::cubic_spline, {0, 1}, {zero, q0, out, zero, q1, zero}};
  for (const auto& [track, time_s, nearer] : {std::tuple{early, 0.25, q0}, std::tuple{late, 0.75, q1}}) {
    const auto at = sample_track<double>(track, time_s);
    EXPECT_LE(test::angle_between(at, nearer), 1e-15) << "truth at " << time_s;
    EXPECT_LE(test::angle_between(one(track).at(time_s).rotation, nearer), 1e-7) << "clip at " << time_s;
    for (const double aside : {-1e-3, 1e-3})  // next to it the curve has a direction, which is neither key
      EXPECT_GT(test::angle_between(one(track).at(time_s + aside).rotation, nearer), 0.01);
  }
}

TEST(sample_clip, ten_thousand_joints_and_a_hundred_thousand_keys_work) {
  test::FixedRandom random(10);
  std::vector<BoneAnimation> bones(10000);
  for (std::uint32_t j = 0; j < bones.size(); ++j) {
    bones[j].joint = j;
    bones[j].rotation = test::random_rotations(random, Interpolation::linear, {0, 1, 2});
  }
  const std::size_t keys = 100000;
  bones[7].translation.times_s.resize(keys);
  bones[7].translation.values.resize(keys);
  for (std::size_t k = 0; k < keys; ++k) {
    bones[7].translation.times_s[k] = static_cast<float>(k) / 64;
    bones[7].translation.values[k] = {static_cast<float>(k), 0, 0};
  }
  Player player(std::move(bones), 10000);
  for (const double t : {0.5, 1.25, 1500.3}) {
    EXPECT_EQ(run(player.job(t)), ErrorCode::ok);
    EXPECT_NEAR(double(player.pose.span().get(7).translation.x), t * 64, 0.01);
    const BoneAnimation& last = player.animation.bones.back();
    EXPECT_LE(test::angle_between(player.pose.span().get(9999).rotation, last.interpolate<double>(t).rotation), 4e-7);
  }
}

TEST(sample_clip, allocates_nothing) {
  Player player = crowded(100, 8);
  const test::AllocationCounter counter;
  for (int i = 0; i < 20; ++i) EXPECT_EQ(run(player.job(i * 0.2)), ErrorCode::ok);
  EXPECT_EQ(counter.count(), 0u);
}

TEST(allocation_counter, sees_every_form_of_new) {
  const test::AllocationCounter counter;
  std::vector<int> v(3);
  const std::string s(100, 'x');
  EXPECT_GE(counter.count(), 2u);
}

}  // namespace
}  // namespace sinew
