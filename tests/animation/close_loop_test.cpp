// SPDX-License-Identifier: MIT
#include "runtime/animation/close_loop.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "runtime/animation/track_sample.h"
#include "runtime/math/interpolate.h"
#include "tests/support/near.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

glm::quat about_y(double angle_rad) {
  return quat_xyzw(0.0f, static_cast<float>(std::sin(angle_rad / 2)), 0.0f,
                   static_cast<float>(std::cos(angle_rad / 2)));
}

/// An animation of two seconds. The translation is linear over the whole time; rotations have keys up to 1.5 s.
Animation two_tracks() {
  Animation animation;
  animation.duration_s = 2.0;
  animation.bones.resize(1);
  animation.bones[0].translation =
      test::track_of<glm::vec3>(Interpolation::linear, {0, 1, 2}, {{1, 0, 0}, {2, 0, 0}, {5, 0, 0}});
  animation.bones[0].rotation =
      test::track_of<glm::quat>(Interpolation::linear, {0.5f, 1.5f}, {about_y(0.2), about_y(1.0)});
  animation.weights.push_back({0, {Interpolation::linear, {0, 2}, {0, 1, 10, -1}, 2}});
  return animation;
}

Transformd pose_at(const Animation& animation, double time_s) {
  return animation.bones[0].interpolate<double>(time_s, {});
}

TEST(close_loop, G12_interpolates_from_the_last_pose_to_the_first_over_the_gap) {
  const Animation open = two_tracks();
  const Animation closed = close_loop(open, 0.5).value();
  EXPECT_EQ(closed.duration_s, 2.5);
  EXPECT_NEAR(pose_at(closed, 2.25).translation.x, 3.0, 1e-15);
  EXPECT_NEAR(pose_at(closed, 2.125).translation.x, 4.0, 1e-15);
  EXPECT_LT(test::angle_between(pose_at(closed, 2.25).rotation, about_y(0.6)), 1e-7);
  EXPECT_LT(test::angle_between(pose_at(closed, 2.0).rotation, about_y(1.0)), 1e-7);  // constant from 1.5 s on
  double weights[2];
  sample_track(closed.weights[0].weights, 2.25, std::span<double>(weights));
  EXPECT_EQ(weights[0], 5.0);
  EXPECT_EQ(weights[1], 0.0);
}

TEST(close_loop, G12_the_end_of_the_gap_is_the_start_bit_for_bit_and_what_was_there_stays) {
  for (const Interpolation kind : {Interpolation::step, Interpolation::linear, Interpolation::squad}) {
    Animation open = two_tracks();
    open.bones[0].rotation.interpolation = kind;
    open.bones[0].rotation.times_s = {0.0f, 2.0f};
    const Animation closed = close_loop(open, 0.25).value();
    EXPECT_EQ(closed.bones[0].interpolate<float>(closed.duration_s), closed.bones[0].interpolate<float>(0.0));
    if (kind == Interpolation::squad) continue;  // its control points depend on the next key
    for (double t = 0; t <= 2.0; t += 0.125) EXPECT_EQ(pose_at(closed, t), pose_at(open, t)) << t;
  }
}

TEST(close_loop, without_it_a_loop_holds_its_last_key_and_jumps) {
  const Animation open = two_tracks();
  EXPECT_EQ(pose_at(open, 2.25).translation.x, 5.0);
}

TEST(close_loop, G07_step_tracks_hold_through_the_gap) {
  Animation open = two_tracks();
  open.bones[0].translation.interpolation = Interpolation::step;
  const Animation closed = close_loop(open, 0.5).value();
  EXPECT_EQ(pose_at(closed, 2.49).translation.x, 5.0);
  EXPECT_EQ(pose_at(closed, 2.5).translation.x, 1.0);
}

/// x = sin(pi t) with cubic keys and exact tangents. The period is 2 s, and the last half second is missing.
Animation sine() {
  Animation animation;
  animation.duration_s = 1.5;
  animation.bones.resize(1);
  Vec3Track& track = animation.bones[0].translation;
  track.interpolation = Interpolation::cubic_spline;
  constexpr double kPi = 3.14159265358979323846;
  for (int k = 0; k <= 3; ++k) {
    const double t = 0.5 * k;
    const glm::vec3 speed(static_cast<float>(kPi * std::cos(kPi * t)), 0, 0);
    track.times_s.push_back(static_cast<float>(t));
    const bool first = k == 0, last = k == 3;
    const glm::vec3 unused(1e6f);  // the outermost tangents have no effect
    track.values.insert(track.values.end(),
                        {first ? unused : speed, {static_cast<float>(std::sin(kPi * t)), 0, 0}, last ? unused : speed});
  }
  return animation;
}

TEST(close_loop, G03_a_cubic_spline_keeps_its_speed_across_the_seam) {
  const Animation closed = close_loop(sine(), 0.5).value();
  constexpr double kPi = 3.14159265358979323846;
  for (double t = 1.5; t < 2.0; t += 0.03125)
    EXPECT_NEAR(pose_at(closed, t).translation.x, std::sin(kPi * t), 0.02) << t;
  const double h = 1e-4;
  const double before = (pose_at(closed, 2.0).translation.x - pose_at(closed, 2.0 - h).translation.x) / h;
  const double after = (pose_at(closed, h).translation.x - pose_at(closed, 0.0).translation.x) / h;
  EXPECT_NEAR(before, kPi, 1e-2);
  EXPECT_NEAR(before, after, 1e-2);
}

TEST(close_loop, G03_a_cubic_track_that_ends_early_holds_and_then_leaves_at_rest) {
  Animation open = sine();
  open.duration_s = 3.0;
  open.bones[0].translation.values[9].x = 2.0f;  // in-tangent of the last key
  const Animation closed = close_loop(open, 1.0).value();
  for (double t = 1.5; t <= 3.0; t += 0.125) EXPECT_NEAR(pose_at(closed, t).translation.x, -1.0, 1e-15) << t;
  const double h = 1e-4;
  EXPECT_NEAR((pose_at(closed, 3.0 + h).translation.x + 1.0) / h, 0.0, 1e-2);
  EXPECT_EQ(pose_at(closed, 4.0).translation.x, 0.0);
}

TEST(close_loop, G03_a_cubic_track_that_begins_late_is_reached_at_rest) {
  Animation open = sine();
  for (float& time_s : open.bones[0].translation.times_s) time_s += 0.5f;
  open.duration_s = 2.0;
  const Animation closed = close_loop(open, 1.0).value();
  for (double t = 0.0; t <= 0.5; t += 0.125) EXPECT_NEAR(pose_at(closed, t).translation.x, 0.0, 1e-15) << t;
  const double h = 1e-4;
  EXPECT_NEAR(pose_at(closed, 3.0 - h).translation.x / h, 0.0, 1e-2);
}

TEST(close_loop, G03_G13_a_cubic_track_that_jumps_at_its_end_leaves_at_rest) {
  Animation open = sine();
  Vec3Track& track = open.bones[0].translation;
  track.times_s.push_back(track.times_s.back());
  const glm::vec3 speed(7, 0, 0);  // in-tangent of the second key, which has no effect
  track.values.insert(track.values.end(), {speed, {3, 0, 0}, speed});
  const Animation closed = close_loop(open, 1.0).value();
  const double h = 1e-4;
  EXPECT_EQ(pose_at(closed, 1.5).translation.x, 3.0);
  EXPECT_NEAR((pose_at(closed, 1.5 + h).translation.x - 3.0) / h, 0.0, 1e-2);
}

TEST(close_loop, G03_G13_a_cubic_track_that_jumps_at_its_start_is_reached_at_rest) {
  Animation open = sine();
  Vec3Track& track = open.bones[0].translation;
  track.times_s.insert(track.times_s.begin(), 0.0f);
  const glm::vec3 speed(7, 0, 0);  // out-tangent of the first key, which has no effect
  track.values.insert(track.values.begin(), {speed, {3, 0, 0}, speed});
  const Animation closed = close_loop(open, 0.5).value();
  const double h = 1e-4;
  EXPECT_EQ(pose_at(closed, 2.0).translation.x, 3.0);
  EXPECT_NEAR((3.0 - pose_at(closed, 2.0 - h).translation.x) / h, 0.0, 1e-2);
}

TEST(close_loop, G05_cubic_rotations_close_on_the_short_arc) {
  Animation open;
  open.duration_s = 1.0;
  open.bones.resize(1);
  const glm::quat none(0, 0, 0, 0);
  open.bones[0].rotation = {Interpolation::cubic_spline, {0, 1}, {none, about_y(0.1), none, none, -about_y(0.5), none}};
  const Animation closed = close_loop(open, 1.0).value();
  EXPECT_LT(test::angle_between(pose_at(closed, 1.5).rotation, about_y(0.3)), 1e-6);
  EXPECT_LT(test::angle_between(pose_at(closed, 2.0).rotation, about_y(0.1)), 1e-7);
}

TEST(close_loop, G05_the_closing_key_of_a_cubic_rotation_changes_sides_with_its_tangents) {
  Animation open;
  open.duration_s = 1.0;
  open.bones.resize(1);
  const glm::quat none(0, 0, 0, 0), first = about_y(0.1), last = -about_y(0.5), speed(0.01f, 0.02f, 0.03f, 0.04f);
  open.bones[0].rotation = {Interpolation::cubic_spline, {0, 1}, {none, first, speed, speed, last, none}};
  const QuatTrack closed = close_loop(open, 1.0).value().bones[0].rotation;
  ASSERT_EQ(closed.values.size(), 9u);
  EXPECT_EQ(closed.values[7], -first);  // negated, to be near the last key
  EXPECT_EQ(closed.values[6], -speed);  // in-tangent: the negated out-tangent of the first key
  EXPECT_EQ(closed.values[5], speed);   // out-tangent of the last key: its in-tangent
}

TEST(close_loop, G05_the_closing_key_of_a_cubic_rotation_stays_on_its_side_where_that_is_nearer) {
  Animation open;
  open.duration_s = 1.0;
  open.bones.resize(1);
  const glm::quat none(0, 0, 0, 0), first = about_y(0.1), last = about_y(0.5), speed(0.01f, 0.02f, 0.03f, 0.04f);
  open.bones[0].rotation = {Interpolation::cubic_spline, {0, 1}, {none, first, speed, speed, last, none}};
  const QuatTrack closed = close_loop(open, 1.0).value().bones[0].rotation;
  ASSERT_EQ(closed.values.size(), 9u);
  EXPECT_EQ(closed.values[7], first);
  EXPECT_EQ(closed.values[6], speed);
}

TEST(close_loop, G12_every_track_of_a_bone_closes) {
  Animation open;
  open.duration_s = 1.0;
  open.bones.resize(1);
  open.bones[0].translation = test::track_of<glm::vec3>(Interpolation::linear, {0, 1}, {{1, 2, 3}, {3, 4, 5}});
  open.bones[0].rotation = test::track_of<glm::quat>(Interpolation::linear, {0, 1}, {about_y(0.1), about_y(0.5)});
  open.bones[0].scale = test::track_of<glm::vec3>(Interpolation::linear, {0, 1}, {{1, 1, 2}, {3, 5, 4}});
  const Animation closed = close_loop(open, 1.0).value();
  const Transformd middle = pose_at(closed, 1.5), end = pose_at(closed, 2.0);
  EXPECT_EQ(middle.translation, glm::dvec3(2, 3, 4));
  EXPECT_LT(test::angle_between(middle.rotation, about_y(0.3)), 1e-7);
  EXPECT_EQ(middle.scale, glm::dvec3(2, 3, 3));
  EXPECT_EQ(end.translation, glm::dvec3(1, 2, 3));
  EXPECT_EQ(end.scale, glm::dvec3(1, 1, 2));
}

PropertyTrack color_of_light(Interpolation kind, std::initializer_list<float> times_s,
                             std::initializer_list<float> values) {
  return {{PropertyKind::light_color, 0}, {kind, times_s, values, 3}};
}

std::array<double, 3> color_at(const Animation& animation, double time_s) {
  std::array<double, 3> color{};
  sample_track(animation.properties[0].values, time_s, std::span<double>(color));
  return color;
}

using Color = std::array<double, 3>;

TEST(close_loop, G12_properties_close_as_other_tracks_do) {
  Animation open;
  open.duration_s = 2.0;
  open.properties.push_back(color_of_light(Interpolation::linear, {0, 2}, {0, 1, 2, 4, 5, 0}));
  const Animation linear = close_loop(open, 0.5).value();
  EXPECT_EQ(color_at(linear, 2.25), (Color{2, 3, 1}));
  EXPECT_EQ(color_at(linear, 2.5), (Color{0, 1, 2}));
  open.properties[0].values.interpolation = Interpolation::step;
  const Animation step = close_loop(open, 0.5).value();
  EXPECT_EQ(color_at(step, 2.49), (Color{4, 5, 0}));
  EXPECT_EQ(color_at(step, 2.5), (Color{0, 1, 2}));
}

TEST(close_loop, G03_a_cubic_property_keeps_its_speed_across_the_seam) {
  Animation open;
  open.duration_s = 1.0;  // from 1 with speed 3 to 2 with speed 5; outermost tangents have no effect
  open.properties.push_back(
      color_of_light(Interpolation::cubic_spline, {0, 1}, {9, 9, 9, 1, 1, 1, 3, 3, 3, 5, 5, 5, 2, 2, 2, 9, 9, 9}));
  const Animation closed = close_loop(open, 1.0).value();
  const double h = 1e-6;
  EXPECT_NEAR((color_at(closed, 1.0 + h)[1] - 2.0) / h, 5.0, 1e-4);
  EXPECT_NEAR((1.0 - color_at(closed, 2.0 - h)[1]) / h, 3.0, 1e-4);
  EXPECT_EQ(color_at(closed, 2.0), (Color{1, 1, 1}));
}

TEST(close_loop, closed_tracks_are_valid_and_compile) {
  Scene scene;
  scene.skeleton = test::chain_skeleton(1);
  scene.meshes.push_back({"mesh", {}, {0.0f, 0.0f}, {}});
  scene.instances.push_back({0, 0, kNone, {0.0f, 0.0f}});
  scene.animations.push_back(close_loop(two_tracks(), 0.5).value());
  scene.animations.push_back(close_loop(sine(), 0.5).value());
  scene.lights.emplace_back();
  Animation light;
  light.properties.push_back(color_of_light(Interpolation::linear, {0}, {1, 1, 1}));
  scene.animations.push_back(close_loop(light, 1.0).value());
  finish_scene(scene);
  EXPECT_EQ(check(scene), ErrorCode::ok);
  EXPECT_EQ(scene.clips[0].duration_s(), 2.5);
}

TEST(close_loop, refuses_a_gap_that_is_none) {
  const Animation open = two_tracks();
  EXPECT_EQ(close_loop(open, 0.0).error(), ErrorCode::unsupported);
  EXPECT_EQ(close_loop(open, -1.0).error(), ErrorCode::unsupported);
  EXPECT_EQ(close_loop(open, 1e-9).error(), ErrorCode::unsupported);
  EXPECT_EQ(close_loop(open, std::numeric_limits<double>::quiet_NaN()).error(), ErrorCode::not_finite);
}

TEST(close_loop, an_animation_without_keys_only_gets_longer) {
  Animation still;
  still.bones.resize(1);
  const Animation closed = close_loop(still, 1.0).value();
  EXPECT_TRUE(closed.bones[0].empty());
  EXPECT_EQ(closed.duration_s, 1.0);
}

}  // namespace
}  // namespace sinew
