// SPDX-License-Identifier: MIT
#include "runtime/animation/bone_animation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/reference/sampling.h"
#include "tests/support/near.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

template <class T = double>
Quat<T> about_x(double angle_rad) {
  return quat_cast<T>(quat_xyzw(std::sin(angle_rad / 2), 0.0, 0.0, std::cos(angle_rad / 2)));
}

BoneAnimation rotating(QuatTrack track) {
  BoneAnimation bone;
  bone.rotation = std::move(track);
  return bone;
}

BoneAnimation moving(Vec3Track track) {
  BoneAnimation bone;
  bone.translation = std::move(track);
  return bone;
}

TEST(bone_animation, whole_keyframes_make_three_tracks) {
  const Keyframe keys[] = {{1.0, {1, 2, 3}, quat_identity<float>(), {1, 1, 1}},
                           {3.0, {3, 2, 1}, about_x<float>(1.0), {2, 2, 2}}};
  const auto bone = BoneAnimation::from_keyframes(7, keys);
  ASSERT_TRUE(bone.has_value());
  EXPECT_EQ(bone->joint, 7u);
  EXPECT_EQ(bone->start_time(), 1.0);
  EXPECT_EQ(bone->end_time(), 3.0);
  const Transformd middle = bone->interpolate<double>(2.0);
  EXPECT_TRUE(test::is_near(middle.translation, {2, 2, 2}, 1e-15));
  EXPECT_TRUE(test::is_near(middle.scale, {1.5, 1.5, 1.5}, 1e-15));
  EXPECT_LE(test::angle_between(middle.rotation, about_x(0.5)), 1e-7);
}

TEST(bone_animation, whole_keyframes_are_checked) {
  const Keyframe falling[] = {{2.0, {}, quat_identity<float>(), {}}, {1.0, {}, quat_identity<float>(), {}}};
  EXPECT_EQ(BoneAnimation::from_keyframes(0, falling).error(), ErrorCode::times_not_increasing);
  EXPECT_EQ(BoneAnimation::from_keyframes(0, {}).error(), ErrorCode::too_few_keys);
  EXPECT_EQ(BoneAnimation::from_keyframes(0, falling, Interpolation::cubic_spline).error(), ErrorCode::unsupported);
}

TEST(bone_animation, missing_tracks_leave_the_rest_value) {
  const BoneAnimation bone = moving(test::track_of<glm::vec3>(Interpolation::linear, {0}, {{1, 1, 1}}));
  const Transformd rest{{9, 9, 9}, about_x(0.3), {4, 5, 6}};
  const Transformd found = bone.interpolate<double>(0.5, rest);
  EXPECT_EQ(found.translation, Vec3<double>(1, 1, 1));
  EXPECT_EQ(found.rotation, rest.rotation);
  EXPECT_EQ(found.scale, rest.scale);
  EXPECT_TRUE(BoneAnimation{}.empty());
  EXPECT_EQ(BoneAnimation{}.start_time(), 0.0);
}

TEST(bone_animation, start_and_end_span_all_tracks) {
  BoneAnimation bone = moving(test::track_of<glm::vec3>(Interpolation::linear, {2, 3}, {{}, {}}));
  bone.scale = test::track_of<glm::vec3>(Interpolation::step, {1, 5}, {{}, {}});
  EXPECT_EQ(bone.start_time(), 1.0);
  EXPECT_EQ(bone.end_time(), 5.0);
}

TEST(bone_animation, G01_N02_rotation_takes_the_short_arc_whatever_the_signs) {
  for (const float sign : {1.0f, -1.0f}) {
    const auto bone =
        rotating({Interpolation::linear, {0, 1}, {about_x<float>(0), about_x<float>(21 * kDegree) * sign}});
    const auto quarter = bone.interpolate<double>(0.25).rotation;
    EXPECT_LE(test::angle_between(quarter, about_x(5.25 * kDegree)), 1e-7) << "sign " << sign;
  }
}

TEST(bone_animation, G02_keys_half_a_turn_apart_give_a_unit_rotation_of_constant_speed) {
  const auto bone =
      rotating({Interpolation::linear, {0, 1}, {quat_identity<float>(), quat_xyzw(1.0f, 0.0f, 0.0f, 0.0f)}});
  for (int i = 1; i < 16; ++i) {
    const auto q = bone.interpolate<double>(i / 16.0).rotation;
    EXPECT_TRUE(test::same_rotation(q, about_x(i / 16.0 * 180 * kDegree), 1e-14));
  }
}

TEST(bone_animation, G03_hand_computed_cubic_with_tangents_times_interval) {
  // One component, td = 2: at s = 1/2 the basis is 1/2, td/8, 1/2, -td/8.
  BoneAnimation bone = moving(
      {Interpolation::cubic_spline, {1, 3}, {{99, 0, 0}, {1, 0, 0}, {4, 0, 0}, {8, 0, 0}, {5, 0, 0}, {77, 0, 0}}});
  EXPECT_DOUBLE_EQ(bone.interpolate<double>(2.0).translation.x, 0.5 * 1 + 2 * 0.125 * 4 + 0.5 * 5 - 2 * 0.125 * 8);
}

TEST(bone_animation, G04_cubic_rotation_is_normalised) {
  const glm::quat zero = quat_xyzw(0.0f, 0.0f, 0.0f, 0.0f);
  const auto bone =
      rotating({Interpolation::cubic_spline, {0, 1}, {zero, about_x<float>(0), zero, zero, about_x<float>(2.0), zero}});
  for (const double t : {0.1, 0.5, 0.7}) EXPECT_NEAR(safe_length(bone.interpolate<double>(t).rotation), 1, 1e-15);
}

TEST(bone_animation, G05_cubic_through_zero_falls_back_to_the_nearer_key) {
  const glm::quat zero = quat_xyzw(0.0f, 0.0f, 0.0f, 0.0f), q = about_x<float>(0.5);
  const auto bone = rotating({Interpolation::cubic_spline, {0, 1}, {zero, q, zero, zero, -q, zero}});
  EXPECT_TRUE(test::same_rotation(bone.interpolate<double>(0.5).rotation, q, 1e-6));
}

TEST(bone_animation, G05_cubic_is_evaluated_as_stored_without_sign_fix) {
  const glm::quat zero = quat_xyzw(0.0f, 0.0f, 0.0f, 0.0f);
  const QuatTrack track{
      Interpolation::cubic_spline, {0, 1}, {zero, about_x<float>(0), zero, zero, -about_x<float>(1.0), zero}};
  const auto expected = reference::quat_of(reference::sample(track, 0.25));
  EXPECT_LE(test::angle_between(rotating(track).interpolate<double>(0.25).rotation, expected), 1e-14);
}

TEST(bone_animation, G06_returns_stored_value_exactly_on_a_key) {
  test::FixedRandom random(6);
  for (const auto interpolation :
       {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline, Interpolation::squad}) {
    const auto times = test::random_times(random, 20);
    const QuatTrack track = test::random_rotations(random, interpolation, times);
    for (std::size_t k = 0; k < times.size(); ++k) {
      const glm::quat stored = track.values[interpolation == Interpolation::cubic_spline ? 3 * k + 1 : k];
      EXPECT_EQ(rotating(track).interpolate<float>(double(times[k])).rotation, stored);
    }
  }
}

TEST(bone_animation, G07_step_holds_until_just_before_the_next_key) {
  const auto bone =
      moving(test::track_of<glm::vec3>(Interpolation::step, {0, 1, 2}, {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}}));
  EXPECT_EQ(bone.interpolate<double>(std::nextafter(1.0, 0.0)).translation.x, 1);
  EXPECT_EQ(bone.interpolate<double>(1.0).translation.x, 2);
  EXPECT_EQ(bone.interpolate<double>(1.999).translation.x, 2);
  EXPECT_EQ(bone.interpolate<double>(2.0).translation.x, 3);
}

TEST(bone_animation, G08_G10_one_key_is_constant_and_times_outside_clamp) {
  const auto one = moving(test::track_of<glm::vec3>(Interpolation::linear, {2}, {{5, 6, 7}}));
  for (const double t : {-1e9, 0.0, 2.0, 1e9}) EXPECT_EQ(one.interpolate<double>(t).translation, Vec3<double>(5, 6, 7));
  const auto two = moving(test::track_of<glm::vec3>(Interpolation::linear, {1, 2}, {{1, 0, 0}, {2, 0, 0}}));
  EXPECT_EQ(two.interpolate<double>(0.5).translation.x, 1);
  EXPECT_EQ(two.interpolate<double>(7.0).translation.x, 2);
}

TEST(bone_animation, G13_equal_times_jump_from_the_first_value_to_the_last) {
  const auto bone = moving(test::track_of<glm::vec3>(Interpolation::linear, {0, 1, 1, 1, 2},
                                                     {{0, 0, 0}, {10, 0, 0}, {55, 0, 0}, {20, 0, 0}, {30, 0, 0}}));
  EXPECT_NEAR(bone.interpolate<double>(0.5).translation.x, 5, 1e-14);
  EXPECT_NEAR(bone.interpolate<double>(std::nextafter(1.0, 0.0)).translation.x, 10, 1e-13);
  EXPECT_EQ(bone.interpolate<double>(1.0).translation.x, 20);
  EXPECT_NEAR(bone.interpolate<double>(1.5).translation.x, 25, 1e-14);
}

TEST(bone_animation, agrees_with_the_reference_for_random_tracks) {
  test::FixedRandom random(11);
  for (const auto interpolation :
       {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline, Interpolation::squad}) {
    const auto times = test::random_times(random, 30, 3);
    const bool squad = interpolation == Interpolation::squad;  // for rotations only
    BoneAnimation bone = moving(test::random_vectors(random, squad ? Interpolation::linear : interpolation, times));
    bone.rotation = test::random_rotations(random, interpolation, times);
    for (int i = 0; i < 500; ++i) {
      const double t = random.in(-0.5, double(times.back()) + 0.5);
      const Transformd found = bone.interpolate<double>(t);
      EXPECT_TRUE(test::is_near(found.translation, reference::vec3_of(reference::sample(bone.translation, t)), 1e-13));
      EXPECT_LE(test::angle_between(found.rotation, reference::quat_of(reference::sample(bone.rotation, t))),
                squad ? 1e-11 : 1e-13);
    }
  }
}

TEST(bone_animation, N07_squad_holds_where_keys_are_held) {
  const glm::quat q = about_x<float>(1.1);
  const auto bone = rotating({Interpolation::squad, {0, 1, 2, 3}, {q, q, q, q}});
  for (const double t : {0.3, 1.5, 2.9})
    EXPECT_TRUE(test::same_rotation(bone.interpolate<double>(t).rotation, q, 1e-7));
}

TEST(bone_animation, N08_squad_does_not_depend_on_the_signs_of_its_keys) {
  test::FixedRandom random(8);
  const QuatTrack track = test::random_rotations(random, Interpolation::squad, {0, 1, 2, 3, 4});
  for (std::size_t flipped = 0; flipped < 5; ++flipped) {
    QuatTrack other = track;
    other.values[flipped] = -other.values[flipped];
    for (const double t : {0.4, 1.5, 2.6, 3.3})
      EXPECT_LE(test::angle_between(rotating(track).interpolate<double>(t).rotation,
                                    rotating(other).interpolate<double>(t).rotation),
                1e-14);
  }
}

TEST(bone_animation, N09_squad_about_one_axis_is_smooth_across_uneven_keys) {
  // The angular speed is the same on both sides of each inner key.
  const auto bone = rotating({Interpolation::squad,
                              {0, 1, 1.25f, 3},
                              {about_x<float>(0), about_x<float>(0.4), about_x<float>(0.9), about_x<float>(1.2)}});
  const auto angle = [&](double t) {
    const auto q = bone.interpolate<double>(t).rotation;
    return 2 * std::atan2(q.x, q.w);
  };
  const double h = 1e-5;
  for (const double key : {1.0, 1.25}) {
    const double before = (angle(key) - angle(key - h)) / h, after = (angle(key + h) - angle(key)) / h;
    EXPECT_NEAR(before, after, 1e-3 * std::abs(after) + 1e-3);
  }
}

TEST(bone_animation, G13_squad_does_not_reach_across_a_jump) {
  const auto q = [](double a) { return about_x<float>(a); };
  const QuatTrack with_jump{Interpolation::squad, {0, 1, 2, 2, 3}, {q(0), q(0.5), q(0.7), q(2.5), q(3)}};
  const QuatTrack alone{Interpolation::squad, {0, 1, 2}, {q(0), q(0.5), q(0.7)}};
  for (const double t : {0.2, 1.1, 1.9})
    EXPECT_LE(test::angle_between(rotating(with_jump).interpolate<double>(t).rotation,
                                  rotating(alone).interpolate<double>(t).rotation),
              1e-14);
}

TEST(bone_animation, N24_ten_hours_in_the_fraction_is_taken_in_double) {
  const float begin = 36000.0f, end = 36001.0f;
  const auto bone = moving(test::track_of<glm::vec3>(Interpolation::linear, {begin, end}, {{0, 0, 0}, {1, 0, 0}}));
  EXPECT_NEAR(bone.interpolate<double>(36000.0001).translation.x, 1e-4, 1e-10);
  EXPECT_NEAR(double(bone.interpolate<float>(36000.0001).translation.x), 1e-4, 1e-10);
}

}  // namespace
}  // namespace sinew
