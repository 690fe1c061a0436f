// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <rapidcheck/gtest.h>
#include <array>

#include "tests/procedures/chains.h"
#include "tests/procedures/limbs.h"

namespace sinew::test {
namespace {

using V = Vec3<double>;

constexpr Vec3<float> kEven{1.0f};

TwoBoneGoal random_goal(Limb& limb, FixedRandom& random) {
  TwoBoneGoal goal = limb.goal(limb.place(1) + random.direction<double>() * random.in(0.0, 2.2));
  goal.pole_kind = static_cast<PoleKind>(random.below(4));
  goal.pole = random.vec3<double>(-2, 2);
  goal.twist_rad = static_cast<float>(random.in(-3, 3));
  goal.weight = random.below(2) == 0 ? 1.0f : static_cast<float>(random.in(0.01, 1));
  goal.soft_reach = random.below(2) == 0 ? 0.0f : 0.02f;
  goal.blend = static_cast<IkBlend>(random.below(2));
  return goal;
}

RC_GTEST_PROP(ik_properties, a_motion_of_parent_target_and_pole_turns_no_joint, (std::uint64_t seed)) {
  FixedRandom random(seed);
  Limb limb = random_limb(random, kEven);
  TwoBoneGoal goal = random_goal(limb, random);
  const Quat<double> turn = random.rotation<double>();
  Limb moved = limb;
  Transform parent = moved.get(0);
  parent.rotation = quat_cast<float>(turn * quat_cast<double>(parent.rotation));
  parent.translation = Vec3<float>(rotate_vector(turn, V(parent.translation)));
  moved.set(0, parent);
  const IkResult here = limb.solve(goal);
  goal.target = rotate_vector(turn, goal.target);
  if (goal.pole_kind != PoleKind::tip_axis) goal.pole = rotate_vector(turn, goal.pole);
  const IkResult there = moved.solve(goal);
  // The parent is rounded to float. Near the end of the reach and near the pole small errors turn joints far.
  RC_ASSERT(std::abs(here.metres_left - there.metres_left) < 1e-5f);
  RC_ASSERT(distance(rotate_vector(turn, limb.place(3)), moved.place(3)) < 2e-3);
}

RC_GTEST_PROP(ik_properties, bones_keep_their_lengths_and_rotations_are_unit, (std::uint64_t seed)) {
  FixedRandom random(seed);
  Limb limb = random_limb(random, kEven);
  const double upper = distance(limb.place(1), limb.place(2)), lower = distance(limb.place(2), limb.place(3));
  limb.solve(random_goal(limb, random));
  RC_ASSERT(std::abs(distance(limb.place(1), limb.place(2)) - upper) < 1e-6);
  RC_ASSERT(std::abs(distance(limb.place(2), limb.place(3)) - lower) < 1e-6);
  for (const std::uint32_t j : {1u, 2u}) RC_ASSERT(std::abs(safe_length(limb.get(j).rotation) - 1.0f) < 2e-7f);
}

RC_GTEST_PROP(ik_properties, reached_means_within_the_tolerance, (std::uint64_t seed)) {
  FixedRandom random(seed);
  Limb limb = random_limb(random, kEven);
  TwoBoneGoal goal = random_goal(limb, random);
  const double bones = length_of(limb);
  const IkResult result = limb.solve(goal);
  const double left = limb.left(goal.target);
  RC_ASSERT(std::abs(static_cast<double>(result.metres_left) - left) < 1e-6);
  RC_ASSERT((result.status == IkStatus::reached) ==
            (static_cast<double>(result.metres_left) <= static_cast<double>(goal.tolerance) * bones * (1 + 1e-6)));
  if (result.status == IkStatus::unreachable) {
    const Bounds bounds = bounds_of(limb);
    const double d = distance(goal.target, limb.place(1));
    RC_ASSERT(goal.blend == IkBlend::effector || d > bounds.most * (1 - 1e-6) || d < bounds.least * (1 + 1e-6));
  }
}

RC_GTEST_PROP(ik_properties, chains_tell_what_is_left, (std::uint64_t seed)) {
  FixedRandom random(seed);
  Posed posed = random_chain(random, 2 + random.below(6), 2.0);
  const auto count = static_cast<std::uint32_t>(posed.skeleton.joint_count() - 1);
  const std::vector joints = all_joints(count);
  const std::array effectors{ChainEffector{.joint = count, .target = random.vec3<double>(-1, 1)}};
  const IkResult result = ChainRun{
      posed, {.joints = joints, .effectors = effectors, .solver = kSolvers[random.below(3)], .iterations = 10}}();
  const double left = distance(posed.place(count), effectors[0].target);
  RC_ASSERT(std::abs(static_cast<double>(result.metres_left) - left) < 2e-6);
  RC_ASSERT(result.iterations <= 10u);
  RC_ASSERT((result.status == IkStatus::reached) == (result.metres_left <= 1e-4f));
  RC_ASSERT(result.status != IkStatus::unreachable || safe_length(effectors[0].target) > 1.0 - 1e-5);
}

}  // namespace
}  // namespace sinew::test
