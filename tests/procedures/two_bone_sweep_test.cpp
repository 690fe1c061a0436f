// SPDX-License-Identifier: MIT
// Targets that move by a thousandth of the limb a step through the places where two-bone solvers give up. No joint may
// turn by more than 2 degrees a step. runtime/procedures/README.md lists the places where no solver can do that.
#include <gtest/gtest.h>

#include "runtime/math/axis_angle.h"
#include "tests/procedures/limbs.h"

namespace sinew::test {
namespace {

using V = Vec3<double>;
constexpr double kMostTurn_deg = 2.0;

/// A limb of 1 m with its root at the origin, bent by `bend_rad` about x.
Limb bent_limb(float bend_rad, float upper = 0.5f) {
  Limb limb({}, {0, -upper, 0}, {0, upper - 1.0f, 0});
  limb.set(2, {.translation = {0, -upper, 0}, .rotation = quat_from_axis_angle(Vec3<float>(1, 0, 0), 0.5f)});
  limb.rest();
  limb.set(2, {.translation = {0, -upper, 0}, .rotation = quat_from_axis_angle(Vec3<float>(1, 0, 0), bend_rad)});
  return limb;
}

/// Largest turn between neighbouring steps, with the target at target(i).
template <class Target>
double worst_step(const Limb& input, TwoBoneGoal goal, int steps, const Target& target) {
  double worst = 0.0;
  std::optional<Limb> last;
  for (int i = 0; i <= steps; ++i) {
    Limb limb = input;
    goal.target = target(i);
    limb.solve(goal);
    if (last) worst = std::max(worst, largest_turn_deg(last->pose.span(), limb.pose.span()));
    last = std::move(limb);
  }
  return worst;
}

TEST(two_bone_sweep, through_straight_with_soft_reach) {
  for (const float bend : {0.0f, 0.005f, 0.5f, 2.0f})
    for (const float upper : {0.5f, 0.4f, 0.7f}) {
      Limb limb = bent_limb(bend, upper);
      TwoBoneGoal goal = limb.goal({});
      goal.soft_reach = static_cast<float>(kSoftReach);
      const auto away = [](int i) { return normalised_or(V(0.1, -1, 0.3), V(0)) * (0.6 + 0.001 * i); };
      EXPECT_LT(worst_step(limb, goal, 600, away), kMostTurn_deg) << bend << ' ' << upper;
    }
}

TEST(two_bone_sweep, beside_a_limb_out_of_reach) {
  Limb limb = bent_limb(0.4f);
  const auto around = [](int i) { return V(std::sin(0.001 * i), -std::cos(0.001 * i), 0.2) * 1.3; };
  EXPECT_LT(worst_step(limb, limb.goal({}), 1500, around), kMostTurn_deg);
}

TEST(two_bone_sweep, to_folded_and_back) {
  for (const float upper : {0.5f, 0.4f})
    for (const float bend : {0.3f, 3.1f, 3.14159265f}) {
      Limb limb = bent_limb(bend, upper);
      const auto in_and_out = [](int i) { return V(0.2, -1, 0.1) * (0.5 - 0.001 * std::min(i, 998 - i)); };
      EXPECT_LT(worst_step(limb, limb.goal({}), 998, in_and_out), 7.5) << "unequal bones meet the end of their reach";
      if (upper == 0.5f) {
        EXPECT_LT(worst_step(limb, limb.goal({}), 998, in_and_out), kMostTurn_deg) << bend;
      }
    }
}

TEST(two_bone_sweep, up_to_the_root_and_onto_it) {
  Limb limb = bent_limb(0.5f);
  const V along = limb.place(3) / safe_length(limb.place(3));  // the target comes along the line of the tip
  const auto onto = [&](int i) { return along * (0.3 - 0.001 * i); };
  EXPECT_LT(worst_step(limb, limb.goal({}), 300, onto), kMostTurn_deg);
}

TEST(two_bone_sweep, a_target_that_crosses_the_line_of_the_pole) {
  // The pose is bent about x, so its middle joint is in the plane x = 0. The target crosses the pole across it.
  for (const double reach : {0.4, 0.6, 0.9})
    for (const double side : {1.0, -1.0}) {
      Limb limb = bent_limb(0.5f);
      TwoBoneGoal goal = limb.goal({});
      goal.pole_kind = PoleKind::direction;
      goal.pole = V(0, -side, 0);
      const int steps = static_cast<int>(reach * 2000);
      const auto across = [&](int i) {
        const double angle = (i - steps / 2) * 0.001 / reach;
        return V(std::sin(angle), -std::cos(angle), 0) * reach;
      };
      EXPECT_LT(worst_step(limb, goal, steps, across), kMostTurn_deg) << reach << ' ' << side;
      goal.pole_fade = 0.0f;
      EXPECT_GT(worst_step(limb, goal, steps, across), 80.0) << "without the fade it snaps";
    }
}

TEST(two_bone_sweep, an_input_pose_that_passes_through_straight_on_its_own_side) {
  double worst = 0.0;
  std::optional<Limb> last;
  for (int i = 0; i <= 1000; ++i) {
    Limb limb = bent_limb(static_cast<float>(std::abs(i - 500)) * 0.001f);
    limb.solve(limb.goal({0.1, -0.7, 0.2}));
    if (last) worst = std::max(worst, largest_turn_deg(last->pose.span(), limb.pose.span()));
    last = std::move(limb);
  }
  EXPECT_LT(worst, 0.2);
}

TEST(two_bone_sweep, random_paths_in_reach_turn_smoothly_but_for_known_places) {
  // A thousand random lines of 0.3 limbs. The test leaves out lines near the root, near the end of the reach, and near
  // the direction opposite to the input's tip. No rule is smooth there.
  FixedRandom random(4);
  int measured = 0;
  for (int path = 0; path < 1000; ++path) {
    Limb limb = bent_limb(static_cast<float>(random.in(0.1, 2.5)));
    const V from = random.direction<double>() * random.in(0.3, 0.9), way = random.direction<double>() * 0.3;
    const V tip = normalised_or(limb.place(3), V(0));
    bool known = false;
    for (int i = 0; i <= 300; ++i) {
      const V at = from + way * (i / 300.0);
      const double d = safe_length(at);
      known = known || d < 0.35 || d > 0.98 || glm::dot(at, tip) < -0.7 * d;
    }
    if (known) continue;
    ++measured;
    EXPECT_LT(worst_step(limb, limb.goal({}), 300, [&](int i) { return from + way * (i / 300.0); }), kMostTurn_deg)
        << path;
  }
  EXPECT_GT(measured, 200);
}

}  // namespace
}  // namespace sinew::test
