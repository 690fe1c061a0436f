// SPDX-License-Identifier: MIT
// Limbs in lanes: against the general solver, which is the truth, against each limb alone, and on every instruction
// set.
#include "runtime/procedures/limb_lanes.h"

#include <gtest/gtest.h>

#include "tests/procedures/limbs.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/simd_targets.h"

namespace sinew::test {
namespace {

using V = Vec3<double>;

/// A goal of random kind, within reach or out of it.
TwoBoneGoal random_goal(Limb& limb, FixedRandom& random, int i) {
  TwoBoneGoal goal = limb.goal(reachable(limb, random));
  if (i % 5 == 0) goal.target += random.vec3<double>(-3, 3);
  goal.pole_kind = static_cast<PoleKind>(i % 4);
  goal.pole = random.vec3<double>(-1, 1);
  if (i % 3 == 1) goal.middle_axis = random.direction();
  if (i % 6 == 2) goal.least_bend_rad = 0.3f;
  if (i % 6 == 2) goal.most_bend_rad = 2.5f;
  if (i % 7 == 3) goal.soft_reach = 0.05f;
  if (i % 7 == 4) goal.most_stretch = 1.3f;
  if (i % 11 == 5) goal.pole_fade = 0.0f;
  if (i % 13 == 6) goal.end = EndRotation::keep;
  return goal;
}

/// Limbs with their goals, in poses of their own.
struct ManyLimbs {
  std::vector<Limb> limbs;
  std::vector<TwoBoneIkJob> jobs;
  std::vector<IkResult> results;

  explicit ManyLimbs(int count) : results(static_cast<std::size_t>(count)) {
    const Vec3<float> scales[] = {{1, 1, 1}, {2, 2, 2}, {1, 2, 1}, {-3, -3, -3}, {0.01f, 0.01f, 0.01f}};
    FixedRandom random(31);
    std::vector<TwoBoneGoal> goals;
    for (int i = 0; i < count; ++i) {
      limbs.push_back(random_limb(random, scales[i % 5]));
      goals.push_back(random_goal(limbs.back(), random, i));
      if (i % 17 == 8) goals.back().weight = 0.5f;
      if (i % 17 == 9) goals.back().weight = 0.0f;
      if (i % 17 == 10) goals.back().twist_rad = 0.4f;
    }
    for (std::size_t i = 0; i < limbs.size(); ++i)
      jobs.push_back({&limbs[i].skeleton, limbs[i].pose.span(), goals[i], nullptr, &results[i]});
  }
};

TEST(limb_lanes, turn_joints_as_the_general_solver_does) {
  FixedRandom random(30);
  int plain = 0;
  for (int i = 0; i < 20000; ++i) {
    Limb general = random_limb(random, i % 2 == 0 ? Vec3<float>(1, 1, 1) : Vec3<float>(1, 2, 1));
    const TwoBoneGoal goal = random_goal(general, random, i);
    Limb lanes = general;
    IkResult wanted, found;
    ik::solve_general({&general.skeleton, general.pose.span(), goal, nullptr, &wanted});
    ik::run_limbs(std::vector<TwoBoneIkJob>{{&lanes.skeleton, lanes.pose.span(), goal, nullptr, &found}});
    // With a given hinge, the general solver takes the reach along the hinge off again, which costs digits near
    // straight: 5e-4 degrees with fused products, 1.1e-3 without. The distance to the target hardly changes there.
    const double most_deg = goal.middle_axis == Vec3<float>(0.0f) ? 3e-5 : 2e-3;
    EXPECT_LT(largest_turn_deg(general.pose.span(), lanes.pose.span()), most_deg) << i;
    EXPECT_EQ(wanted.status, found.status) << i;
    EXPECT_NEAR(wanted.metres_left, found.metres_left, 1e-6f * (1.0f + wanted.metres_left)) << i;
    if (general.bits() != lanes.bits()) ++plain;
  }
  EXPECT_GT(plain, 100) << "the lanes solved limbs by formulas of their own";
}

TEST(limb_lanes, together_is_each_alone_bit_for_bit_on_every_instruction_set) {
  ManyLimbs alone(203);
  for (const TwoBoneIkJob& job : alone.jobs) ASSERT_EQ(run(job), ErrorCode::ok);
  for (const std::int64_t target : simd_targets()) {
    const OnlyTarget only(target);
    ManyLimbs together(203);
    AllocationCounter counter;
    ASSERT_EQ(run(TwoBoneIkLimbsJob{together.jobs}), ErrorCode::ok);
    EXPECT_EQ(counter.count(), 0u);
    for (std::size_t i = 0; i < together.limbs.size(); ++i) {
      EXPECT_EQ(together.limbs[i].bits(), alone.limbs[i].bits()) << simd_name(target) << ' ' << i;
      EXPECT_EQ(together.results[i], alone.results[i]) << simd_name(target) << ' ' << i;
    }
  }
}

TEST(limb_lanes, common_limbs_need_no_general_solver) {
  FixedRandom random(32);
  ik::PlainLimbs limbs;
  ik::SolvedLimbs solved;
  int count = 0, left = 0;
  for (int i = 0; i < 4000; ++i) {
    Limb limb = random_limb(random, {1, 1, 1});
    TwoBoneGoal goal = limb.goal(reachable(limb, random));
    goal.pole_kind = PoleKind::direction;
    goal.pole = random.direction<double>();
    ik::read_plain({&limb.skeleton, limb.pose.span(), goal}, limbs, 0);
    ik::solve_limbs(limbs, 1, false, solved);
    ++count;
    left += solved.is_solved[0] == 0.0 ? 1 : 0;
  }
  EXPECT_LT(left, count / 100);
}

/// Lanes make quaternions of nearly unit length unit. The general solver takes the others.
TEST(limb_lanes, quaternions_of_any_length_are_made_unit) {
  FixedRandom random(33);
  for (const float length : {1.0f - 4e-4f, 1.0f + 4e-4f, 0.9f, 2.0f}) {
    Limb unit = random_limb(random, {1, 1, 1}), scaled = unit;
    const TwoBoneGoal goal = unit.goal(reachable(unit, random));
    for (const std::uint32_t joint : {goal.root, goal.middle})
      scaled.pose.span().set_rotation(joint, scaled.pose.span().get(joint).rotation * length);
    ASSERT_EQ(run(TwoBoneIkJob{&unit.skeleton, unit.pose.span(), goal}), ErrorCode::ok);
    ASSERT_EQ(run(TwoBoneIkJob{&scaled.skeleton, scaled.pose.span(), goal}), ErrorCode::ok);
    EXPECT_LT(largest_turn_deg(unit.pose.span(), scaled.pose.span()), 1e-4) << length;
  }
}

TEST(limb_lanes, one_limb_that_is_refused_stops_all) {
  ManyLimbs many(20);
  many.jobs[13].goal.target.x = std::nan("");
  const std::vector<float> before = many.limbs[0].bits();
  EXPECT_EQ(run(TwoBoneIkLimbsJob{many.jobs}), ErrorCode::not_finite);
  EXPECT_EQ(many.limbs[0].bits(), before);
  EXPECT_EQ(check(TwoBoneIkLimbsJob{{static_cast<const TwoBoneIkJob*>(nullptr), 2}}), ErrorCode::size_mismatch);
  EXPECT_EQ(run(TwoBoneIkLimbsJob{}), ErrorCode::ok);
}

}  // namespace
}  // namespace sinew::test
