// SPDX-License-Identifier: MIT
#include "runtime/playback/root_track.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "runtime/math/axis_angle.h"
#include "tests/playback/motion_distance.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using test::apart;
using Vec3d = Vec3<double>;

glm::quat heading(double angle_rad) { return quat_cast<float>(quat_from_axis_angle(Vec3d(0, 1, 0), angle_rad)); }

/// A straight walk: `speed` metres a second along z, with a bob in y.
BoneAnimation straight_walk(float speed, float duration_s) {
  BoneAnimation root;
  const float length = speed * duration_s;
  root.translation = {Interpolation::linear,
                      {0.0f, 0.5f * duration_s, duration_s},
                      {{0, 1, 0}, {0, 1.1f, 0.5f * length}, {0, 1, length}}};
  return root;
}

/// A root joint that moves at random. Keys are at uneven times; translation and rotation have different ones.
BoneAnimation wander(test::FixedRandom& random, Interpolation interpolation) {
  BoneAnimation root;
  root.translation.interpolation = root.rotation.interpolation = interpolation;
  const std::size_t values_per_key = interpolation == Interpolation::cubic_spline ? 3 : 1;
  float time_s = 0.0f;
  for (int k = 0; k < 9; ++k) {
    root.translation.times_s.push_back(time_s);
    root.rotation.times_s.push_back(1.1f * time_s);
    for (std::size_t v = 0; v < values_per_key; ++v) {
      root.translation.values.push_back(random.vec3<float>(-2, 2));
      root.rotation.values.push_back(heading(random.in(-1.0, 1.0)));
    }
    time_s += static_cast<float>(random.in(0.05, 0.4));
  }
  return root;
}

TEST(root_track, stays_within_its_tolerance_of_the_authoring_keys) {
  test::FixedRandom random(7);
  for (const Interpolation interpolation : {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline}) {
    for (const RootTurn turn : {RootTurn::none, RootTurn::heading, RootTurn::full, RootTurn::heading_euler}) {
      const BoneAnimation root = wander(random, interpolation);
      const RootMotionParts parts{true, turn != RootTurn::heading, true, turn};
      const RootTrack track = RootTrack::make(root, {}, parts, 1e-4);
      EXPECT_LE(track.measured_error(), 1e-4);
      double worst = 0.0;
      for (int i = 0; i <= 5000; ++i) {
        const double time_s = -0.1 + i * 1e-3;
        worst = std::max(worst, apart(track.place(time_s), root_place(root, {}, parts, time_s)));
      }
      EXPECT_LE(worst, 1.5e-4) << "eight times in an interval are measured, these are others";
    }
  }
}

TEST(root_track, what_is_baked_out_and_what_moves_the_character_make_the_authored_joint) {
  test::FixedRandom random(11);
  for (const Interpolation interpolation : {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline}) {
    const BoneAnimation root = wander(random, interpolation);
    const Transform rest{{1, 2, 3}, heading(0.3), {1, 1, 1}};
    const RootTrack track = RootTrack::make(root, rest, {}, 1e-4);
    const BoneAnimation baked = bake_out_root(root, rest, track, 1e-4);
    EXPECT_EQ(check(baked.translation), ErrorCode::ok);
    EXPECT_EQ(check(baked.rotation), ErrorCode::ok);
    double worst = 0.0;
    for (int i = 0; i <= 5000; ++i) {
      const double time_s = -0.1 + i * 1e-3;
      const Transformd on_the_spot = baked.interpolate<double>(time_s, {});
      const Transformd whole = root.interpolate<double>(
          time_s, {Vec3<double>(rest.translation), quat_cast<double>(rest.rotation), Vec3<double>(rest.scale)});
      worst = std::max(worst, apart(track.place(time_s) * dual_quat_from(on_the_spot.rotation, on_the_spot.translation),
                                    dual_quat_from(whole.rotation, whole.translation)));
    }
    EXPECT_LE(worst, interpolation == Interpolation::step ? 1e-3 : 2e-4);
  }
}

TEST(root_track, a_straight_walk_that_is_baked_out_bobs_on_the_spot) {
  const BoneAnimation walk = straight_walk(1.5f, 1.0f);
  const BoneAnimation baked = bake_out_root(walk, {}, RootTrack::make(walk, {}, {}, 1e-5), 1e-5);
  EXPECT_EQ(baked.translation.times_s.size(), 3u);
  for (const glm::vec3& place : baked.translation.values) EXPECT_LE(std::abs(place.x) + std::abs(place.z), 2e-5f);
  EXPECT_NEAR(baked.translation.values[1].y, 1.1f, 1e-5f);
}

TEST(root_track, keeps_only_the_keys_that_it_needs) {
  const RootMotionParts ground;
  EXPECT_EQ(RootTrack::make(straight_walk(1.5f, 1.0f), {}, ground, 1e-5).keys().size(), 2u) << "the bob stays";
  EXPECT_EQ(RootTrack::make(straight_walk(0.0f, 1.0f), {}, ground, 1e-5).keys().size(), 1u);
  EXPECT_EQ(RootTrack::make({}, {}, ground, 1e-5).keys().size(), 1u);
  EXPECT_EQ(RootTrack::make({}, {}, ground, 1e-5).measured_error(), 0.0);
  const RootMotionParts all{true, true, true, RootTurn::full};
  EXPECT_EQ(RootTrack::make(straight_walk(1.5f, 1.0f), {}, all, 1e-5).keys().size(), 3u);
  EXPECT_LT(apart(RootTrack().place(3.0), {}), 1e-15);
}

TEST(root_track, jumps_where_step_keys_do) {
  BoneAnimation root;
  root.translation = {Interpolation::step, {0.0f, 1.0f, 2.0f}, {{0, 0, 0}, {3, 0, 0}, {3, 0, 1}}};
  const RootTrack track = RootTrack::make(root, {}, {}, 1e-6);
  EXPECT_EQ(translation_of(track.place(std::nextafter(1.0, 0.0))).x, 0.0);
  EXPECT_EQ(translation_of(track.place(1.0)).x, 3.0);
  EXPECT_EQ(translation_of(track.place(1.999)), Vec3d(3, 0, 0));
  EXPECT_EQ(translation_of(track.place(2.5)), Vec3d(3, 0, 1));
}

TEST(root_track, carries_over_many_rounds_as_the_authoring_keys_do) {
  test::FixedRandom random(11);
  const BoneAnimation root = wander(random, Interpolation::linear);
  const RootTrack track = RootTrack::make(root, {}, {}, 1e-6);
  for (const double dt_s : {0.01, 2.9, 40.0, -7.0}) {
    PlaybackClock clock(root.end_time()), other(root.end_time());
    for (int i = 0; i < 7; ++i) {
      const DualQuatd moved = track.motion(clock.advance(dt_s));
      EXPECT_LT(apart(moved, root_motion(root, {}, {}, other.advance(dt_s))), 2e-5 * (1.0 + std::fabs(dt_s))) << dt_s;
    }
  }
}

/// Positions of the root joint and of the character after two blended clips have played.
struct Stands {
  Vec3d joint, character;
};
Stands play_blended(std::array<BoneAnimation, 2> roots, double w, int frames) {
  const RootMotionParts parts;
  std::array<PlaybackClock, 2> clocks{PlaybackClock(roots[0].end_time()), PlaybackClock(roots[1].end_time())};
  const std::array<double, 2> weights{1.0 - w, w};
  DualQuatd world;
  Stands stands{};
  for (int f = 0; f < frames; ++f) {
    std::array<RootShare, 2> shares;
    Vec3d joint(0.0);
    Quat<double> turn = quat_xyzw(0.0, 0.0, 0.0, 0.0);
    for (std::size_t c = 0; c < 2; ++c) {
      const PlaybackStep step = clocks[c].advance(1.0 / 60.0);
      const double time_s = clocks[c].time_s();
      shares[c] = {root_motion(roots[c], {}, parts, step), root_place(roots[c], {}, parts, time_s), weights[c]};
      const Transformd local = roots[c].interpolate<double>(time_s, {});
      joint += local.translation * weights[c];
      turn = turn + aligned_with(turn, local.rotation) * weights[c];
    }
    const BlendedRoot blended = blend_root_motion(shares);
    world = normalised(world * blended.motion);
    const DualQuatd root = world * dual_quat_conjugate(blended.place);
    stands = {transform_point(root, joint), translation_of(world)};
  }
  return stands;
}

TEST(root_motion, a_blended_root_joint_stands_where_the_character_does) {
  // 1.5 and 6 m/s for two seconds at a quarter: 2 (0.75 * 1.5 + 0.25 * 6) = 5.25 m.
  const Stands stands = play_blended({straight_walk(1.5f, 1.0f), straight_walk(6.0f, 0.7f)}, 0.25, 120);
  EXPECT_NEAR(stands.character.z, 5.25, 1e-6);
  EXPECT_NEAR(stands.joint.z, stands.character.z, 1e-12);
  EXPECT_NEAR(stands.joint.x, 0.0, 1e-12);
  EXPECT_GT(stands.joint.y, 0.99) << "the height is no part of the motion";
}

TEST(root_motion, blended_turns_keep_the_joint_with_the_character) {
  BoneAnimation left = straight_walk(1.5f, 1.0f), right = straight_walk(3.0f, 1.0f);
  left.rotation = {Interpolation::linear, {0.0f, 1.0f}, {heading(0.0), heading(0.5)}};
  right.rotation = {Interpolation::linear, {0.0f, 1.0f}, {heading(0.0), heading(-0.9)}};
  const Stands stands = play_blended({left, right}, 0.5, 95);
  EXPECT_NEAR(stands.joint.x, stands.character.x, 1e-12);
  EXPECT_NEAR(stands.joint.z, stands.character.z, 1e-12);
}

TEST(root_motion, a_blend_treats_q_and_minus_q_as_equal_and_normalises_weights) {
  const DualQuatd turn = dual_quat_from(quat_from_axis_angle(Vec3d(0, 1, 0), 0.4), Vec3d(1, 0, 0));
  const DualQuatd same{-turn.real, -turn.dual};
  const std::array<RootShare, 3> shares{RootShare{turn, same, 0.2}, RootShare{same, turn, 0.6}, RootShare{{}, {}, 0.0}};
  const BlendedRoot blended = blend_root_motion(shares);
  EXPECT_LT(apart(blended.motion, turn), 1e-15);
  EXPECT_LT(apart(blended.place, turn), 1e-15);
  EXPECT_LT(apart(blend_root_motion({}).motion, {}), 1e-15);
}

}  // namespace
}  // namespace sinew
