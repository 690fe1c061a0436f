// SPDX-License-Identifier: MIT
#include "runtime/procedures/two_bone_ik.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "runtime/math/axis_angle.h"
#include "tests/procedures/limbs.h"
#include "tests/support/allocation_counter.h"

namespace sinew::test {
namespace {

using V = Vec3<double>;

const Vec3<float> kScales[] = {{1, 1, 1}, {2, 2, 2}, {1, 2, 1}, {-3, -3, -3}, {0.01f, 0.01f, 0.01f}, {1, 1, -2}};

/// The leg of a standing figure: hip at 1 m, knee a little forward, ankle at the ground.
Limb leg() {
  Limb limb({.translation = {0, 1, 0}}, {0, -0.5f, 0}, {0, -0.5f, 0});
  limb.set(1, {.rotation = quat_from_axis_angle(Vec3<float>(1, 0, 0), -0.2f)});
  limb.set(2, {.translation = {0, -0.5f, 0}, .rotation = quat_from_axis_angle(Vec3<float>(1, 0, 0), 0.4f)});
  limb.rest();
  return limb;
}

TEST(two_bone_ik, reaches_within_a_millionth_of_the_limb_below_parents_of_any_scale) {
  FixedRandom random(1);
  for (const Vec3<float>& scale : kScales)
    for (int i = 0; i < 4000; ++i) {
      Limb limb = random_limb(random, scale);
      const V target = reachable(limb, random);
      const double length = length_of(limb);
      const IkResult result = limb.solve(limb.goal(target));
      EXPECT_LT(limb.left(target), 1e-6 * std::max(length, length_of(limb))) << scale.x << ' ' << scale.y << ' ' << i;
      EXPECT_EQ(result.status, IkStatus::reached);
      EXPECT_NEAR(result.metres_left, limb.left(target), 1e-6 * length);
    }
}

TEST(two_bone_ik, reaches_a_million_metres_away) {
  FixedRandom random(2);
  for (int i = 0; i < 2000; ++i) {
    Limb limb = random_limb(random, Vec3<float>(1.0f), 1e6);
    const V target = reachable(limb, random);
    limb.solve(limb.goal(target));
    EXPECT_LT(limb.left(target), 1e-6 * length_of(limb)) << i;
  }
}

TEST(two_bone_ik, reaches_where_joints_of_the_limb_scale_unevenly) {
  FixedRandom random(3);
  int reached = 0;
  for (int i = 0; i < 2000; ++i) {
    Limb limb = random_limb(random, {1, 1, 1});
    Transform root = limb.get(1), middle = limb.get(2);
    root.scale = random.vec3(0.5, 1.5);
    middle.scale = random.vec3(0.5, 1.5);
    limb.set(1, root);
    limb.set(2, middle);
    const V now = limb.place(3) - limb.place(1);
    const V target = limb.place(1) + random.direction<double>() * safe_length(now) * random.in(0.9, 1.05);
    const IkResult result = limb.solve(limb.goal(target));
    EXPECT_NEAR(result.metres_left, limb.left(target), 1e-6);
    if (result.status == IkStatus::reached) ++reached;
    if (result.status != IkStatus::unreachable) {
      EXPECT_LT(limb.left(target), 2e-6) << i;
    }
  }
  EXPECT_GT(reached, 1200);
}

TEST(two_bone_ik, points_straight_at_targets_that_are_out_of_reach) {
  FixedRandom random(4);
  for (const Vec3<float>& scale : kScales)
    for (int i = 0; i < 500; ++i) {
      Limb limb = random_limb(random, scale);
      const V away = random.direction<double>() * bounds_of(limb).most * random.in(1.001, 10.0);
      const V target = transform_point(limb.model(0), V(limb.get(1).translation) + away);
      const IkResult result = limb.solve(limb.goal(target));
      EXPECT_EQ(result.status, IkStatus::unreachable);
      EXPECT_NEAR(result.metres_left, limb.left(target), 1e-5 * safe_length(target - limb.place(1)));
      const V whole = target - limb.place(1);
      EXPECT_LT(angle_of(limb.place(2) - limb.place(1), whole), 1e-6) << i;
      EXPECT_LT(angle_of(limb.place(3) - limb.place(2), whole), 1e-6) << i;
    }
}

TEST(two_bone_ik, weight_zero_keeps_every_bit) {
  FixedRandom random(5);
  Limb limb = random_limb(random, {1, 2, 1});
  const std::vector<float> before = limb.bits();
  TwoBoneGoal goal = limb.goal({0.3, 0.2, 0.1});
  goal.weight = 0.0f;
  EXPECT_EQ(limb.solve(goal), IkResult{});
  EXPECT_EQ(limb.bits(), before);
}

TEST(two_bone_ik, a_tip_that_is_there_moves_nothing) {
  FixedRandom random(6);
  for (int i = 0; i < 500; ++i) {
    Limb limb = random_limb(random, {1, 1, 1});
    const V whole = limb.place(3) - limb.place(1), upper = limb.place(2) - limb.place(1);
    if (safe_length(glm::cross(whole, upper)) < 0.03) continue;
    Limb solved = limb;
    solved.solve(solved.goal(limb.place(3)));
    EXPECT_LT(largest_turn_deg(limb.pose.span(), solved.pose.span()), 2e-4) << i;
  }
}

TEST(two_bone_ik, the_middle_joint_goes_towards_its_pole) {
  FixedRandom random(7);
  for (int i = 0; i < 1000; ++i) {
    Limb limb = random_limb(random, kScales[i % 4]);
    TwoBoneGoal goal = limb.goal(reachable(limb, random));
    goal.pole_kind = i % 2 == 0 ? PoleKind::direction : PoleKind::point;
    goal.pole = random.vec3<double>(-5, 5);
    limb.solve(goal);
    const V line = goal.target - limb.place(1), upper = limb.place(2) - limb.place(1);
    const V pole = i % 2 == 0 ? goal.pole : goal.pole - limb.place(1);
    if (std::sin(angle_of(line, pole)) < 0.6 || std::sin(angle_of(line, upper)) < 0.1) continue;
    const V wanted = glm::cross(line, pole), found = glm::cross(line, upper);
    EXPECT_LT(angle_of(wanted, found), 2e-5) << i;
  }
}

TEST(two_bone_ik, the_knee_follows_the_foot_with_its_own_direction_as_pole) {
  Limb limb = leg();
  limb.set(3, {.translation = {0, -0.5f, 0}, .rotation = quat_from_axis_angle(Vec3<float>(0, 1, 0), 0.7f)});
  TwoBoneGoal goal = limb.goal({0, 0.2, 0});
  goal.pole_kind = PoleKind::tip_axis;
  goal.pole = {0, 0, 1};
  goal.end = EndRotation::keep;
  const Quat<double> before = limb.rotation(3);
  const V forward = rotate_vector(before, goal.pole);
  limb.solve(goal);
  const V off = limb.place(2) - V(0, 0.6, 0);
  EXPECT_NEAR(std::atan2(off.x, off.z), std::atan2(forward.x, forward.z), 1e-6);
  EXPECT_LT(angle_between(limb.rotation(3), before), 1e-6) << "the foot keeps its rotation";
}

TEST(two_bone_ik, twist_turns_the_limb_about_the_line_to_the_target) {
  Limb plain = leg(), twisted = leg();
  TwoBoneGoal goal = plain.goal({0.1, 0.3, 0.2});
  plain.solve(goal);
  goal.twist_rad = 0.5f;
  twisted.solve(goal);
  const V line = goal.target - plain.place(1);
  EXPECT_LT(twisted.left(goal.target), 1e-6);
  const V wanted = rotate_vector(quat_from_axis_angle(line, 0.5), plain.place(2) - plain.place(1));
  EXPECT_TRUE(is_near(twisted.place(2) - twisted.place(1), wanted, 1e-6));
}

TEST(two_bone_ik, a_given_hinge_is_the_only_axis_of_the_middle_joint) {
  FixedRandom random(8);
  for (int i = 0; i < 500; ++i) {
    Limb limb = random_limb(random, {2, 2, 2});
    TwoBoneGoal goal = limb.goal(reachable(limb, random));
    goal.middle_axis = random.direction();
    const Transform before = limb.get(2);
    const IkResult result = limb.solve(goal);
    const glm::quat turn = quat_conjugate(before.rotation) * limb.get(2).rotation;
    const AxisAngleT<double> found = axis_angle_from_quat(quat_cast<double>(turn));
    if (found.angle_rad > 0.01) {
      EXPECT_LT(std::sin(angle_of(found.axis, V(goal.middle_axis))), 1e-5) << i;
    }
    if (result.status != IkStatus::unreachable) {
      EXPECT_LT(limb.left(goal.target), 4e-6) << i;
    }
  }
}

TEST(two_bone_ik, soft_reach_is_off_when_it_is_off) {
  Limb limb = leg();
  TwoBoneGoal goal = limb.goal({0, 1 - 0.9999, 0});
  EXPECT_EQ(limb.solve(goal).status, IkStatus::reached);
  EXPECT_LT(limb.left(goal.target), 1e-6);
  goal.soft_reach = 0.01f;
  const IkResult soft = limb.solve(goal);
  EXPECT_EQ(soft.status, IkStatus::limited);
  EXPECT_GT(soft.metres_left, 1e-3f);
  EXPECT_NEAR(soft.metres_left, limb.left(goal.target), 1e-6);
}

TEST(two_bone_ik, bones_grow_up_to_the_stretch_and_no_farther) {
  for (const float most : {1.0f, 1.2f, 2.0f}) {
    Limb limb = leg();
    TwoBoneGoal goal = limb.goal({0, -0.5, 0});  // 1.5 m away from a limb of 1 m
    goal.most_stretch = most;
    const IkResult result = limb.solve(goal);
    const double reach = std::min(1.5, static_cast<double>(most));
    EXPECT_NEAR(distance(limb.place(3), limb.place(1)), reach, 1e-6);
    EXPECT_EQ(result.status == IkStatus::reached, most == 2.0f) << most;
    EXPECT_NEAR(distance(limb.place(1), limb.place(2)), reach / 2, 1e-6);
  }
}

TEST(two_bone_ik, the_bend_stays_within_its_limits) {
  Limb limb = leg();
  TwoBoneGoal goal = limb.goal({0, -3, 0});
  goal.least_bend_rad = 0.3f;
  EXPECT_EQ(limb.solve(goal).status, IkStatus::unreachable);
  EXPECT_NEAR(angle_of(limb.place(2) - limb.place(1), limb.place(3) - limb.place(2)), 0.3, 1e-6);
  goal = limb.goal({0, 0.9, 0});
  goal.most_bend_rad = 2.0f;
  limb.solve(goal);
  EXPECT_NEAR(angle_of(limb.place(2) - limb.place(1), limb.place(3) - limb.place(2)), 2.0, 1e-6);
}

TEST(two_bone_ik, the_tip_takes_the_rotation_that_it_is_given) {
  FixedRandom random(9);
  for (const Vec3<float>& scale : {Vec3<float>(1, 1, 1), Vec3<float>(1, 2, 1), Vec3<float>(-3, -3, -3)}) {
    Limb limb = random_limb(random, scale);
    TwoBoneGoal goal = limb.goal(reachable(limb, random));
    goal.end = EndRotation::given;
    goal.end_rotation = random.rotation();
    const IkResult result = limb.solve(goal);
    EXPECT_LT(angle_between(limb.rotation(3), goal.end_rotation), 1e-6);
    EXPECT_LT(result.radians_left, 1e-6f);
  }
}

TEST(two_bone_ik, a_weight_mixes_the_pose_or_moves_the_tip_along_a_line) {
  FixedRandom random(10);
  for (int i = 0; i < 200; ++i) {
    Limb limb = random_limb(random, {1, 1, 1});
    const V start = limb.place(3), target = reachable(limb, random);
    TwoBoneGoal goal = limb.goal(target);
    goal.weight = 0.25f;
    goal.blend = IkBlend::effector;
    Limb other = limb, full = limb;
    other.solve(goal);
    const V wanted = start + (target - start) * 0.25;
    if (distance(wanted, limb.place(1)) > bounds_of(limb).least + 1e-6) {
      EXPECT_LT(distance(other.place(3), wanted), 3e-6) << i;
    }
    goal.blend = IkBlend::pose;
    Limb mixed = limb;
    mixed.solve(goal);
    goal.weight = 1.0f;
    full.solve(goal);
    for (const std::uint32_t j : {1u, 2u}) {
      const double whole = angle_between(limb.get(j).rotation, full.get(j).rotation);
      if (whole > 2.59) continue;  // near half a turn the share fades
      EXPECT_NEAR(angle_between(limb.get(j).rotation, mixed.get(j).rotation), 0.25 * whole, 2e-6);
    }
  }
}

TEST(two_bone_ik, degenerate_limbs_have_finite_answers) {
  const V targets[] = {{0, 1, 0}, {0, 0.3, 0.2}, {0, -7, 0}};
  for (const Vec3<float>& upper : {Vec3<float>(0.0f), Vec3<float>(0, -0.5f, 0)})
    for (const Vec3<float>& lower : {Vec3<float>(0.0f), Vec3<float>(0, -0.5f, 0), Vec3<float>(0, 0.5f, 0)})
      for (const Vec3<float>& scale : {Vec3<float>(1, 1, 1), Vec3<float>(0, 0, 0), Vec3<float>(1, 0, 1)})
        for (const V& target : targets)
          for (const PoleKind kind : {PoleKind::none, PoleKind::direction}) {
            Limb limb({.translation = {0, 1, 0}, .scale = scale}, upper, lower);
            TwoBoneGoal goal = limb.goal(target);
            goal.pole_kind = kind;
            goal.pole = target - V(0, 1, 0);  // along the limb, or zero
            const IkResult result = limb.solve(goal);
            for (const float number : limb.bits()) ASSERT_TRUE(std::isfinite(number));
            EXPECT_TRUE(std::isfinite(result.metres_left));
          }
}

TEST(two_bone_ik, a_parent_that_flattens_space_keeps_the_pose) {
  Limb limb({.scale = {1, 0, 1}}, {0, -0.5f, 0}, {0, -0.5f, 0});
  const std::vector<float> before = limb.bits();
  EXPECT_EQ(limb.solve(limb.goal({0.2, 0, 0})).status, IkStatus::unreachable);
  EXPECT_EQ(limb.bits(), before);
}

TEST(two_bone_ik, a_straight_limb_bends_as_it_does_at_rest) {
  Limb limb = leg();
  Transform knee = limb.get(2);
  knee.rotation = quat_identity<float>();
  limb.set(2, knee);
  limb.set(1, {});
  limb.solve(limb.goal({0, 0.4, 0}));
  EXPECT_GT(limb.place(2).z, 0.3) << "the knee of the rest pose points forward";
  EXPECT_NEAR(limb.place(2).x, 0.0, 1e-7);
}

TEST(two_bone_ik, joints_between_are_part_of_the_bones) {
  FixedRandom random(11);
  for (int i = 0; i < 200; ++i) {
    Posed posed(chain_skeleton(6));
    for (std::uint32_t j = 0; j < 6; ++j)
      posed.set(j, {.translation = random.vec3(0.1, 0.5), .rotation = random.rotation()});
    TwoBoneGoal goal;
    goal.root = 1;
    goal.middle = 3;
    goal.tip = 5;
    const V root = posed.place(1), upper = posed.place(3) - root, lower = posed.place(5) - posed.place(3);
    const double a = safe_length(upper), b = safe_length(lower);
    goal.target = root + random.direction<double>() * random.in(std::abs(a - b) + 1e-3, a + b - 1e-3);
    const glm::quat fourth = posed.get(4).rotation;
    IkResult result;
    EXPECT_EQ(run(TwoBoneIkJob{&posed.skeleton, posed.pose.span(), goal, nullptr, &result}), ErrorCode::ok);
    EXPECT_LT(distance(posed.place(5), goal.target), 2e-6) << i;
    EXPECT_EQ(posed.get(4).rotation, fourth);
  }
}

TEST(two_bone_ik, refuses_what_it_cannot_solve_and_allocates_nothing) {
  Limb limb = leg();
  const auto code = [&](auto change) {
    TwoBoneIkJob job{&limb.skeleton, limb.pose.span(), limb.goal({0, 0, 0})};
    change(job);
    return check(job);
  };
  EXPECT_EQ(code([](auto&) {}), ErrorCode::ok);
  EXPECT_EQ(code([](auto& job) { job.skeleton = nullptr; }), ErrorCode::size_mismatch);
  EXPECT_EQ(code([](auto& job) { job.local.planes = nullptr; }), ErrorCode::size_mismatch);
  EXPECT_EQ(code([](auto& job) { job.goal.tip = 4; }), ErrorCode::index_out_of_range);
  EXPECT_EQ(code([](auto& job) { job.goal.middle = 1; }), ErrorCode::unsupported);
  EXPECT_EQ(code([](auto& job) { job.goal.target.x = std::nan(""); }), ErrorCode::not_finite);
  EXPECT_EQ(code([](auto& job) { job.goal.weight = 1.5f; }), ErrorCode::not_a_fraction);
  EXPECT_EQ(code([](auto& job) { job.goal.soft_reach = 1.0f; }), ErrorCode::not_a_fraction);
  EXPECT_EQ(code([](auto& job) { job.goal.tolerance = -1.0f; }), ErrorCode::negative_weight);
  EXPECT_EQ(code([](auto& job) { job.goal.least_bend_rad = 4.0f; }), ErrorCode::too_large);
  EXPECT_EQ(code([](auto& job) { job.goal.most_stretch = 0.5f; }), ErrorCode::too_large);
  limb.skeleton.fixed_matrices.emplace_back();
  limb.skeleton.fixed_matrix_of[2] = 0;
  EXPECT_EQ(code([](auto&) {}), ErrorCode::unsupported);
  limb.skeleton.fixed_matrix_of[2] = kNone;
  const TwoBoneIkJob job{&limb.skeleton, limb.pose.span(), limb.goal({0, 0.2, 0.1})};
  AllocationCounter counter;
  run_unchecked(job);
  EXPECT_EQ(counter.count(), 0u);
}

TEST(two_bone_ik, takes_the_matrix_of_the_parent_from_the_caller) {
  FixedRandom random(12);
  Limb a = random_limb(random, {1, 2, 1});
  Limb b = a;
  const TwoBoneGoal goal = a.goal(reachable(a, random));
  a.solve(goal);
  const Affined above = b.model(0);
  EXPECT_EQ(run(TwoBoneIkJob{&b.skeleton, b.pose.span(), goal, &above}), ErrorCode::ok);
  EXPECT_LT(largest_turn_deg(a.pose.span(), b.pose.span()), 1e-4);
}

}  // namespace
}  // namespace sinew::test
