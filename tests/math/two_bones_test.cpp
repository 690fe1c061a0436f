// SPDX-License-Identifier: MIT
#include "runtime/math/two_bones.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using Vec3d = Vec3<double>;

template <class T>
struct Turned {
  Vec3<T> middle, tip;
};

template <class T>
Turned<T> turned(const TwoBonesT<T>& limb, const TwoBoneTurnsT<T>& turns) {
  const Vec3<T> middle = limb.root + rotate_vector(turns.upper, limb.middle - limb.root);
  return {middle, middle + rotate_vector(turns.lower, limb.tip - limb.middle)};
}

TwoBonesT<double> random_limb(test::FixedRandom& random) {
  const Vec3d root = random.vec3<double>(-2, 2);
  const Vec3d middle = root + random.direction<double>() * random.in(0.3, 1.0);
  return {root, middle, middle + random.direction<double>() * random.in(0.3, 1.0)};
}

TEST(two_bones, the_tip_comes_to_every_place_within_reach_and_bones_keep_their_lengths) {
  test::FixedRandom random(1);
  for (int i = 0; i < 2000; ++i) {
    const TwoBonesT<double> limb = random_limb(random);
    const double a = glm::length(limb.middle - limb.root), b = glm::length(limb.tip - limb.middle);
    const double distance = random.in(std::abs(a - b) + 1e-3, 0.98 * (a + b));
    const Vec3d goal = limb.root + random.direction<double>() * distance;
    const Turned<double> found = turned(limb, turn_two_bones(limb, goal, random.direction<double>()));
    EXPECT_TRUE(test::is_near(found.tip, goal, 1e-13 * (a + b) + 1e-14)) << i;
    EXPECT_NEAR(glm::length(found.middle - limb.root), a, 1e-14);
  }
}

TEST(two_bones, a_tip_that_is_there_moves_nothing) {
  test::FixedRandom random(2);
  for (int i = 0; i < 500; ++i) {
    const TwoBonesT<double> limb = random_limb(random);
    const Vec3d along = normalised_or(limb.tip - limb.root, Vec3d(1, 0, 0)), off = limb.middle - limb.root;
    if (glm::length(off - along * glm::dot(off, along)) < 0.05)
      continue;  // nearly straight: `bend` decides, see a test below
    const auto turns = turn_two_bones(limb, limb.tip, random.direction<double>());
    EXPECT_LT(rotation_angle_between(turns.upper, quat_identity<double>()), 1e-13) << i;
    EXPECT_LT(rotation_angle_between(turns.lower, quat_identity<double>()), 1e-13) << i;
  }
}

TEST(two_bones, the_middle_joint_stays_in_the_plane_and_on_its_side) {
  const TwoBonesT<double> leg{{0, 1, 0}, {0, 0.5, 0.1}, {0, 0, 0}};
  const auto found = turned(leg, turn_two_bones(leg, Vec3d(0, 0.3, 0.2), Vec3d(0, 0, -1)));
  EXPECT_NEAR(found.middle.x, 0.0, 1e-15);
  EXPECT_GT(found.middle.z, 0.3) << "the knee points forward as before, whatever the direction of straight legs";
}

TEST(two_bones, a_straight_limb_bends_as_it_is_told) {
  const TwoBonesT<double> leg{{0, 1, 0}, {0, 0.5, 0}, {0, 0, 0}};
  for (const Vec3d& bend : {Vec3d(0, 0, 1), Vec3d(0, 0, -3), Vec3d(1, 5, 0)}) {
    const auto found = turned(leg, turn_two_bones(leg, Vec3d(0, 0.2, 0), bend));
    const Vec3d flat = normalised_or(Vec3d(bend.x, 0, bend.z), Vec3d(0));
    EXPECT_TRUE(test::is_near(found.middle, Vec3d(0, 0.6, 0) + flat * 0.3, 1e-14));
  }
}

TEST(two_bones, nearly_straight_limbs_bend_without_a_jump) {
  // The knee moves through the straight line, from one side to just beyond it.
  Vec3d last(0);
  for (int i = 0; i <= 2000; ++i) {
    const double off = 0.04 - i * 2.5e-5;  // from 0.04 to -0.01
    const TwoBonesT<double> leg{{0, 1, 0}, {0, 0.5, off}, {0, 0, 0}};
    const Vec3d middle = turned(leg, turn_two_bones(leg, Vec3d(0, 0.1, 0), Vec3d(0.3, 0, 1))).middle;
    if (i > 0) {
      EXPECT_LT(glm::length(middle - last), 0.01) << off;
    }
    last = middle;
  }
}

TEST(two_bones, what_is_out_of_reach_is_approached_and_the_knee_never_jumps) {
  const TwoBonesT<double> leg{{0, 1, 0}, {0, 0.5, 0.1}, {0, 0, 0}};
  const double straight = 2.0 * glm::length(leg.middle - leg.root);
  double last = 0.0, last_angle = 0.0;
  for (int i = 0; i <= 400; ++i) {
    const double wanted = 0.9 + i * 0.001;
    const auto found = turned(leg, turn_two_bones(leg, Vec3d(0, 1 - wanted, 0), Vec3d(0, 0, 1)));
    const double distance = glm::length(found.tip - leg.root);
    if (wanted < 0.99 * straight) {
      EXPECT_NEAR(distance, wanted, 1e-14);
    }
    EXPECT_LT(distance, straight);
    EXPECT_GT(distance, last) << wanted;
    const double angle = std::atan2(found.middle.z, 1.0 - found.middle.y);
    if (i > 0) {
      EXPECT_LT(std::abs(angle - last_angle), 0.01) << wanted;
    }
    last = distance;
    last_angle = angle;
  }
}

TEST(two_bones, float_is_double_within_rounding_also_where_a_limb_is_nearly_straight) {
  test::FixedRandom random(3);
  for (int i = 0; i < 2000; ++i) {
    TwoBonesT<double> limb = random_limb(random);
    limb.root = Vec3d(0.0);
    if (i % 2 == 0) limb.tip = limb.middle * (1.0 + random.in(0.5, 1.5)) + random.vec3<double>(-0.05, 0.05);
    const TwoBonesT<float> in_float{Vec3<float>(limb.root), Vec3<float>(limb.middle), Vec3<float>(limb.tip)};
    limb = {Vec3d(in_float.root), Vec3d(in_float.middle), Vec3d(in_float.tip)};
    const double a = glm::length(limb.middle), b = glm::length(limb.tip - limb.middle);
    const Vec3<float> goal(random.direction<double>() * random.in(std::abs(a - b) + 0.05, 1.1 * (a + b)));
    const Vec3<float> bend(random.direction<double>());
    const auto exact = turned(limb, turn_two_bones(limb, Vec3d(goal), Vec3d(bend)));
    const auto found = turned(in_float, turn_two_bones(in_float, goal, bend));
    EXPECT_TRUE(test::is_near(Vec3d(found.tip), exact.tip, 4e-6)) << i;
  }
}

// `d + a - b` lost all digits of d below 3e-8 of a bone, and the limb jumped from folded to fully stretched.
template <class T>
void expect_folds_towards_the_root() {
  const TwoBonesT<T> leg{{0, 0, 0}, {0, T(-0.6), T(0.8)}, {0, T(-1.2), 0}};  // bones of 1 m
  for (T distance = T(1); distance > std::numeric_limits<T>::min(); distance /= T(7)) {
    const Vec3<T> goal = normalised_or(Vec3<T>(1, -2, 0), Vec3<T>(0)) * distance;
    const auto found = turned(leg, turn_two_bones(leg, goal, Vec3<T>(0, 0, 1)));
    EXPECT_LT(glm::length(found.tip - goal), T(8) * std::numeric_limits<T>::epsilon()) << distance;
  }
  const auto folded = turned(leg, turn_two_bones(leg, leg.root, Vec3<T>(0, 0, 1)));
  EXPECT_LT(glm::length(folded.tip), T(8) * std::numeric_limits<T>::epsilon());
  EXPECT_NEAR(glm::length(folded.middle), T(1), T(8) * std::numeric_limits<T>::epsilon());
}

TEST(two_bones, equal_bones_fold_onto_a_goal_near_the_root) {
  expect_folds_towards_the_root<double>();
  expect_folds_towards_the_root<float>();
}

TEST(two_bones, without_soft_reach_goals_up_to_the_whole_length_are_reached) {
  const TwoBonesT<double> leg{{0, 0, 0}, {0, -0.6, 0.8}, {0, -1.2, 0}};
  for (const double wanted : {1.98, 1.9999, 2.0, 2.5}) {
    const auto hard = turned(leg, turn_two_bones(leg, Vec3d(0, -wanted, 0), Vec3d(0, 0, 1), 0.0));
    EXPECT_NEAR(hard.tip.y, -std::min(wanted, 2.0), 1e-14);
    const auto soft = turned(leg, turn_two_bones(leg, Vec3d(0, -wanted, 0), Vec3d(0, 0, 1), 0.1));
    EXPECT_GT(soft.tip.y, -std::min(wanted, 2.0)) << "slows down from 1.8 m on";
  }
}

TEST(two_bones, bones_or_goals_without_length_turn_nothing_or_stay_finite) {
  const TwoBonesT<double> leg{{0, 1, 0}, {0, 0.5, 0.1}, {0, 0, 0}};
  const auto is_identity = [](const TwoBoneTurnsT<double>& turns) {
    return turns.upper == quat_identity<double>() && turns.lower == quat_identity<double>();
  };
  EXPECT_TRUE(is_identity(turn_two_bones<double>({leg.root, leg.root, leg.tip}, Vec3d(1), Vec3d(0, 0, 1))));
  EXPECT_TRUE(is_identity(turn_two_bones<double>({leg.root, leg.tip, leg.tip}, Vec3d(1), Vec3d(0, 0, 1))));
  EXPECT_TRUE(is_identity(turn_two_bones<double>({leg.root, leg.middle, leg.root}, Vec3d(1), Vec3d(0, 0, 1))));
  const auto folded = turned(leg, turn_two_bones(leg, leg.root, Vec3d(0, 0, 1)));
  EXPECT_TRUE(std::isfinite(folded.tip.x + folded.tip.y + folded.tip.z));
  const TwoBonesT<double> unequal{{0, 1, 0}, {0, 0.4, 0.1}, {0, 0, 0}};
  const auto short_of_it = turned(unequal, turn_two_bones(unequal, unequal.root, Vec3d(0, 0, 1)));
  EXPECT_NEAR(glm::length(short_of_it.tip - unequal.root), std::sqrt(0.37) - std::sqrt(0.17), 1e-14)
      << "as near as can be";
}

}  // namespace
}  // namespace sinew
