// SPDX-License-Identifier: MIT
#include "runtime/playback/root_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "runtime/animation/mirror_animation.h"
#include "runtime/math/axis_angle.h"
#include "tests/playback/motion_distance.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using test::apart;
using Vec3d = Vec3<double>;
constexpr double kPi = 3.14159265358979323846;
constexpr RootMotionParts kAll{true, true, true, RootTurn::full};

glm::quat about(const Vec3d& axis, double angle_rad) { return quat_cast<float>(quat_from_axis_angle(axis, angle_rad)); }

/// A walk of one second: it moves 1.25 m along z and 0.25 m along x, bobs up and down, and turns by 25 degrees. It does
/// not start at the origin, nor with heading 0.
BoneAnimation walk() {
  BoneAnimation root;
  root.translation = {Interpolation::linear, {0.0f, 0.5f, 1.0f}, {{2, 1, -1}, {2.1f, 1.1f, -0.4f}, {2.25f, 1, 0.25f}}};
  root.rotation = {
      Interpolation::linear, {0.0f, 1.0f}, {about({0, 1, 0}, 0.7), about({0, 1, 0}, 0.7 + 25 * kPi / 180)}};
  return root;
}

/// The product of the root motions of `frames` steps of `dt_s`.
DualQuatd carried(PlayMode mode, double speed, double dt_s, int frames, const RootMotionParts& parts = kAll) {
  const BoneAnimation root = walk();
  PlaybackClock clock(1.0, mode, speed);
  DualQuatd world;
  for (int f = 0; f < frames; ++f) world = normalised(world * root_motion(root, {}, parts, clock.advance(dt_s)));
  return world;
}

TEST(root_motion, U07_a_step_within_the_clip_is_the_difference_of_two_root_places) {
  const BoneAnimation root = walk();
  PlaybackClock clock(1.0);
  clock.advance(0.25);
  const DualQuatd delta = root_motion(root, {}, kAll, clock.advance(0.5));
  const DualQuatd from = root_place(root, {}, kAll, 0.25), to = root_place(root, {}, kAll, 0.75);
  EXPECT_LT(apart(from * delta, to), 1e-15);
  EXPECT_GT(apart(delta, {}), 0.5);
}

TEST(root_motion, U07_rounds_go_on_where_the_last_one_ended) {
  // Without turning, 7.25 rounds move by 7.25 * 1.25 m.
  const BoneAnimation root = walk();
  PlaybackClock clock(1.0);
  const RootMotionParts parts{true, true, true, RootTurn::none};
  const Vec3d moved = translation_of(root_motion(root, {}, parts, clock.advance(7.25)));
  EXPECT_NEAR(moved.x, 7 * 0.25 + 0.05, 1e-7);
  EXPECT_NEAR(moved.y, 0.05, 1e-7);
  EXPECT_NEAR(moved.z, 7 * 1.25 + 0.3, 1e-7);
}

TEST(root_motion, U07_a_round_moves_from_start_to_end_and_two_rounds_do_so_twice) {
  const BoneAnimation root = walk();
  const DualQuatd round = dual_quat_conjugate(root_place(root, {}, kAll, 0.0)) * root_place(root, {}, kAll, 1.0);
  PlaybackClock once(1.0), twice(1.0);
  EXPECT_LT(apart(root_motion(root, {}, kAll, once.advance(1.0)), round), 1e-14);
  EXPECT_LT(apart(root_motion(root, {}, kAll, twice.advance(2.0)), round * round), 1e-14);
}

// The truth is one step over the whole time. Each rate divides two minutes, which are 120 rounds. Some frames end on
// the seam, others cross it.
TEST(root_motion, U07_frame_rates_agree) {
  for (const double speed : {1.0, -1.0, 0.3, 2.5}) {
    const DualQuatd truth = carried(PlayMode::loop, speed, 120.0, 1);
    EXPECT_LT(apart(carried(PlayMode::loop, speed, 1.0 / 30, 3600), truth), 1e-11) << speed;
    EXPECT_LT(apart(carried(PlayMode::loop, speed, 1.0 / 144, 17280), truth), 1e-11) << speed;
    EXPECT_LT(apart(carried(PlayMode::loop, speed, 1.5, 80), truth), 1e-11) << speed;
    EXPECT_LT(apart(carried(PlayMode::loop, speed, 40.0, 3), truth), 1e-11) << speed;
  }
}

// Each round adds the same rigid motion. After n rounds the heading is n * 25 degrees, and the path is a circle. After
// 72 rounds (five full turns) the character is back.
TEST(root_motion, U07_N24_many_rounds_stay_exact) {
  const BoneAnimation root = walk();
  const double exact_rad = 25 * kPi / 180;
  const auto after = [&](double rounds) {
    PlaybackClock clock(1.0);
    return root_motion(root, {}, {true, true, true, RootTurn::full}, clock.advance(rounds));
  };
  for (const double rounds : {1.0, 3.0, 72.0, 3600.0, 86400.0}) {
    const double expected = std::remainder(rounds * exact_rad, 2 * kPi);
    EXPECT_NEAR(test::angle_between(after(rounds).real, quat_from_axis_angle(Vec3d(0, 1, 0), expected)), 0.0,
                1e-7 * rounds);
    EXPECT_NEAR(safe_length(after(rounds).real), 1.0, 1e-14);
  }
  EXPECT_LT(safe_length(translation_of(after(72.0))), 1e-4);  // keys are floats: 6e-8 rad a round
  EXPECT_GT(safe_length(translation_of(after(36.0))), 0.1);
}

TEST(root_motion, U07_backwards_undoes_forwards) {
  const DualQuatd there = carried(PlayMode::loop, 1.0, 3.7, 1), back = carried(PlayMode::loop, -1.0, 3.7, 1);
  // From the start, 3.7 s back ends at phase 0.3 of round -4: walking on from there for 3.7 s returns.
  const BoneAnimation root = walk();
  PlaybackClock clock(1.0, PlayMode::loop, -1.0);
  DualQuatd world = root_motion(root, {}, kAll, clock.advance(3.7));
  EXPECT_LT(apart(world, back), 1e-15);
  clock.set_speed(1.0);
  world = world * root_motion(root, {}, kAll, clock.advance(3.7));
  EXPECT_LT(apart(world, {}), 1e-12);
  EXPECT_GT(apart(there, back), 1.0);
}

TEST(root_motion, ping_pong_comes_back_and_clamp_stops) {
  EXPECT_LT(apart(carried(PlayMode::ping_pong, 1.0, 0.125, 16 * 5), {}), 1e-13);
  const DualQuatd whole = dual_quat_conjugate(root_place(walk(), {}, kAll, 0.0)) * root_place(walk(), {}, kAll, 1.0);
  EXPECT_LT(apart(carried(PlayMode::ping_pong, 1.0, 0.25, 12), whole), 1e-13);
  const DualQuatd on_the_way_back =
      dual_quat_conjugate(root_place(walk(), {}, kAll, 0.0)) * root_place(walk(), {}, kAll, 0.75);
  EXPECT_LT(apart(carried(PlayMode::ping_pong, 1.0, 0.25, 13), on_the_way_back), 1e-13);
  EXPECT_LT(apart(carried(PlayMode::clamp, 1.0, 0.3, 50), whole), 1e-13);
  EXPECT_LT(apart(carried(PlayMode::once, 2.0, 0.3, 50), whole), 1e-13);
  EXPECT_LT(apart(carried(PlayMode::loop, 0.0, 0.3, 50), {}), 1e-15);
}

TEST(root_motion, parts_that_are_not_named_stay_in_the_pose) {
  BoneAnimation root = walk();
  root.rotation.values[1] = about({0, 1, 0}, 0.4) * about({1, 0, 0}, 0.3);
  const RootMotionParts ground;
  const DualQuatd place = root_place(root, {}, ground, 1.0);
  EXPECT_TRUE(test::is_near(translation_of(place), Vec3d(2.25, 0, 0.25), 1e-15));
  EXPECT_LT(test::angle_between(place.real, quat_from_axis_angle(Vec3d(0, 1, 0), 0.4)), 1e-7);
  // The rest of the pose has no heading and stands above the origin.
  const Transformd local = root.interpolate<double>(1.0, {});
  const DualQuatd left = dual_quat_conjugate(place) * dual_quat_from(local.rotation, local.translation);
  EXPECT_NEAR(left.real.y, 0.0, 1e-8);
  EXPECT_TRUE(test::is_near(translation_of(left), Vec3d(0, 1, 0), 1e-7));
}

TEST(root_motion, a_root_that_rests_turned_has_no_heading_at_rest) {
  Transform rest;
  rest.rotation = quat_xyzw(1.0f, 0.0f, 0.0f, 0.0f);  // as after an exchange of axes; its twist about +Y is undefined
  BoneAnimation root;
  root.rotation = {Interpolation::linear, {0, 1}, {rest.rotation, about({0, 1, 0}, 0.5) * rest.rotation}};
  EXPECT_LT(apart(root_place(root, rest, {}, 0.0), {}), 1e-7);
  const Quat<double> to_the_left = quat_from_axis_angle(Vec3d(0, 1, 0), 0.5);
  EXPECT_LT(test::angle_between(root_place(root, rest, {}, 1.0).real, to_the_left), 1e-6);
}

TEST(root_motion, a_clip_without_length_and_a_root_without_tracks_move_nothing) {
  PlaybackClock clock(0.0);
  EXPECT_LT(apart(root_motion(walk(), {}, kAll, clock.advance(5.0)), {}), 1e-15);
  PlaybackClock other(1.0);
  EXPECT_LT(apart(root_motion({}, {}, kAll, other.advance(5.0)), {}), 1e-15);
}

TEST(root_motion, headings_are_the_twist_or_the_first_euler_angle) {
  test::FixedRandom random(3);
  const Vec3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const auto place = [](const Quat<double>& rotation, RootTurn turn) {
    BoneAnimation root;
    root.rotation = {Interpolation::linear, {0.0f}, {quat_cast<float>(rotation)}};
    return root_place(root, {}, {.turn = turn}, 0.0).real;
  };
  for (int i = 0; i < 1000; ++i) {
    const double heading = random.in(-3.14, 3.14);
    const double lean = random.in(-1.5, 1.5);
    const double roll = random.in(-3.1, 3.1);
    const Quat<double> turned =
        quat_from_axis_angle(y, heading) * quat_from_axis_angle(z, lean) * quat_from_axis_angle(x, roll);
    EXPECT_LT(test::angle_between(place(turned, RootTurn::heading_euler), quat_from_axis_angle(y, heading)), 2e-5);
  }
  const Quat<double> upright = quat_from_axis_angle(y, 0.7) * quat_from_axis_angle(z, 1.5707963267948966);
  EXPECT_LT(test::angle_between(place(upright, RootTurn::heading_euler), quat_from_axis_angle(y, 0.7)), 1e-6);
  const Quat<double> back = quat_from_axis_angle(y, 3.14159265358979);
  EXPECT_LT(test::angle_between(place(back, RootTurn::heading_euler), back), 1e-6);
  const Quat<double> leaning = quat_from_axis_angle(x, 0.8) * quat_from_axis_angle(y, 0.7);
  EXPECT_LT(test::angle_between(place(leaning, RootTurn::heading), quat_from_axis_angle(y, 0.7)), 1e-6);
  EXPECT_GT(test::angle_between(place(leaning, RootTurn::heading_euler), quat_from_axis_angle(y, 0.7)), 0.05);
}

TEST(root_motion, of_a_mirrored_clip_it_is_the_motion_reflected) {
  Skeleton skeleton;
  skeleton.parents = {kNone};
  skeleton.rest = {{}};
  skeleton.fixed_matrix_of = {kNone};
  skeleton.names = {"root"};
  const BoneAnimation root = walk();
  const Animation mirrored = mirror_animation({"walk", 1.0, {root}, {}}, make_mirror_map(skeleton), skeleton);
  PlaybackClock clock(1.0), other(1.0);
  for (const RootTurn turn : {RootTurn::none, RootTurn::heading, RootTurn::full, RootTurn::heading_euler}) {
    const RootMotionParts parts{true, true, true, turn};
    const DualQuatd plain = root_motion(root, {}, parts, clock.advance(2.3));
    const DualQuatd reflected = mirrored_motion(plain, {1, 0, 0});
    EXPECT_LT(apart(root_motion(mirrored.bones[0], {}, parts, other.advance(2.3)), reflected), 1e-12);
    EXPECT_LT(apart(mirrored_motion(reflected, {1, 0, 0}), plain), 1e-15);
    EXPECT_NEAR(translation_of(plain).x, -translation_of(reflected).x, 1e-15);
  }
}

}  // namespace
}  // namespace sinew
