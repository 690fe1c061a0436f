// SPDX-License-Identifier: MIT
#include "runtime/procedures/aim.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "runtime/math/axis_angle.h"
#include "tests/procedures/posed.h"
#include "tests/support/allocation_counter.h"

namespace sinew::test {
namespace {

using V = Vec3<double>;

IkResult aim(Posed& posed, const AimGoal& goal) {
  IkResult result;
  EXPECT_EQ(run(AimJob{&posed.skeleton, posed.pose.span(), goal, &result}), ErrorCode::ok);
  return result;
}

/// Angle between the line of the last joint and the way to the target, by the pose alone.
double angle_left(Posed& posed, const AimGoal& goal) {
  const Affined model = posed.model(goal.joints.back().joint);
  return angle_of(transform_vector(model, V(goal.forward)), goal.target - transform_point(model, V(goal.offset)));
}

Posed random_spine(FixedRandom& random, const Vec3<float>& scale) {
  Posed posed(chain_skeleton(5));
  posed.set(0, {.translation = random.vec3(), .rotation = random.rotation(), .scale = scale});
  for (std::uint32_t j = 1; j < 5; ++j)
    posed.set(j, {.translation = {0, 0.2f, 0}, .rotation = random.rotation_by<float>(0.3)});
  return posed;
}

/// Spine, chest, neck, head that look along +z; joint 4 is the head, 0.8 m up.
Posed figure() {
  Posed posed(chain_skeleton(5));
  for (std::uint32_t j = 1; j < 5; ++j) posed.set(j, {.translation = {0, 0.2f, 0}});
  return posed;
}

constexpr std::array kHead{AimJoint{.joint = 4}};
constexpr std::array kSpine{AimJoint{.joint = 1, .share = 0.2f}, AimJoint{.joint = 2, .share = 0.2f},
                            AimJoint{.joint = 3, .share = 0.3f}, AimJoint{.joint = 4, .share = 0.3f}};

TEST(aim, the_line_runs_through_the_target_below_parents_of_any_scale) {
  FixedRandom random(1);
  for (const Vec3<float>& scale : {Vec3<float>(1, 1, 1), Vec3<float>(2, 2, 2), Vec3<float>(1, 2, 1),
                                   Vec3<float>(-3, -3, -3), Vec3<float>(1, 1, -2)})
    for (int i = 0; i < 1000; ++i) {
      Posed posed = random_spine(random, scale);
      AimGoal goal;
      goal.joints = i % 2 == 0 ? std::span<const AimJoint>(kHead) : std::span<const AimJoint>(kSpine);
      goal.forward = random.direction();
      goal.up = random.direction();
      goal.offset = random.direction() * 0.1f;
      goal.target = posed.place(4) + random.direction<double>() * 8.0;
      if (i % 3 == 0) goal.pole = random.direction<double>();
      const IkResult result = aim(posed, goal);
      EXPECT_LT(angle_left(posed, goal), 2e-6) << i;
      EXPECT_EQ(result.status, IkStatus::reached);
      EXPECT_NEAR(result.radians_left, angle_left(posed, goal), 1e-6);
    }
}

TEST(aim, up_turns_to_the_pole_and_twist_rolls_from_there) {
  FixedRandom random(2);
  for (int i = 0; i < 500; ++i) {
    Posed posed = random_spine(random, {1, 1, 1});
    AimGoal goal;
    goal.joints = kHead;
    goal.target = posed.place(4) + random.direction<double>() * 3.0;
    goal.pole = random.direction<double>();
    goal.twist_rad = i % 2 == 0 ? 0.0f : 0.6f;
    aim(posed, goal);
    const V way = normalised_or(goal.target - posed.place(4), V(0)), up = rotate_vector(posed.rotation(4), V(goal.up));
    if (std::abs(glm::dot(way, goal.pole)) > 0.9) continue;
    const V flat = normalised_or(goal.pole - way * glm::dot(way, goal.pole), V(0));
    const V wanted = rotate_vector(quat_from_axis_angle(way, static_cast<double>(goal.twist_rad)), flat);
    EXPECT_LT(angle_of(up, wanted), 1e-6) << i;
  }
}

TEST(aim, without_a_pole_nothing_rolls) {
  Posed posed = figure();
  AimGoal goal;
  goal.joints = kHead;
  goal.target = {3, 0.8, 3};
  aim(posed, goal);
  EXPECT_TRUE(is_near(rotate_vector(posed.rotation(4), V(0, 1, 0)), V(0, 1, 0), 1e-6));
}

TEST(aim, joints_take_their_shares) {
  Posed posed = figure();
  AimGoal goal;
  goal.joints = kSpine;
  goal.target = {1000, 0.8, 0};  // a quarter turn
  aim(posed, goal);
  for (std::size_t i = 0; i < kSpine.size(); ++i)
    EXPECT_NEAR(angle_between(posed.get(kSpine[i].joint).rotation, quat_identity<float>()),
                static_cast<double>(kSpine[i].share) * std::numbers::pi / 2, 2e-3);
}

TEST(aim, a_weight_turns_a_part_of_the_way_and_zero_keeps_every_bit) {
  Posed posed = figure();
  const std::vector<float> before = posed.bits();
  AimGoal goal;
  goal.joints = kHead;
  goal.target = {5, 0.8, 0};
  goal.weight = 0.0f;
  EXPECT_EQ(aim(posed, goal), IkResult{});
  EXPECT_EQ(posed.bits(), before);
  goal.weight = 0.3f;
  const IkResult result = aim(posed, goal);
  EXPECT_EQ(result.status, IkStatus::limited);
  EXPECT_NEAR(angle_between(posed.get(4).rotation, quat_identity<float>()), 0.15 * std::numbers::pi, 1e-6);
}

TEST(aim, joints_after_a_limited_one_do_what_it_may_not) {
  JointLimit narrow;
  narrow.swing_y_rad = narrow.swing_z_rad = 0.1f;
  narrow.least_twist_rad = -0.1f;
  narrow.most_twist_rad = 0.1f;
  const std::array limits{narrow};
  std::array joints = kSpine;
  joints[0].limit = joints[1].limit = 0;
  Posed posed = figure();
  AimGoal goal;
  goal.joints = joints;
  goal.limits = limits;
  goal.target = {9, 0.8, 0};
  EXPECT_EQ(aim(posed, goal).status, IkStatus::reached);
  joints[2].limit = joints[3].limit = 0;
  posed = figure();
  const IkResult result = aim(posed, goal);
  EXPECT_EQ(result.status, IkStatus::limited);
  EXPECT_NEAR(result.radians_left, std::numbers::pi / 2 - 0.4, 0.05);
  for (const AimJoint& joint : joints)
    EXPECT_LT(angle_between(posed.get(joint.joint).rotation, quat_identity<float>()), 0.1415) << "swing and twist";
}

TEST(aim, a_target_nearer_than_the_line_is_told) {
  Posed posed = figure();
  AimGoal goal;
  goal.joints = kHead;
  goal.offset = {0.5f, 0, 0};
  goal.target = posed.place(4) + V(0, 0.1, 0.2);
  const IkResult result = aim(posed, goal);
  EXPECT_EQ(result.status, IkStatus::unreachable);
  for (const float number : posed.bits()) EXPECT_TRUE(std::isfinite(number));
  goal.target = posed.place(4);
  EXPECT_EQ(aim(posed, goal).status, IkStatus::unreachable);
  for (const float number : posed.bits()) EXPECT_TRUE(std::isfinite(number));
}

/// Largest turn of a joint while the target goes round in steps of 0.001 rad.
template <class Target>
double worst_step(const AimGoal& given, int steps, const Target& target) {
  double worst = 0.0;
  AimGoal goal = given;
  Posed last = figure();
  for (int i = 0; i <= steps; ++i) {
    Posed posed = figure();
    goal.target = target(i);
    aim(posed, goal);
    if (i > 0) worst = std::max(worst, largest_turn_deg(last.pose.span(), posed.pose.span()));
    last = posed;
  }
  return worst;
}

TEST(aim, a_target_that_walks_round_the_figure_snaps_no_joint) {
  JointLimit limit;
  limit.swing_y_rad = 1.2f;
  limit.swing_z_rad = 0.6f;
  limit.least_twist_rad = -1.3f;
  limit.most_twist_rad = 1.3f;
  limit.axes = quat_from_axis_angle(Vec3<float>(0, 0, 1), std::numbers::pi_v<float> / 2);  // x of the limit is up
  const std::array limits{limit};
  std::array joints = kSpine;
  AimGoal goal;
  for (const bool limited : {false, true})
    for (const double height : {0.8, 1.5, 0.1}) {
      for (AimJoint& joint : joints) joint.limit = limited ? 0 : kNone;
      goal.joints = joints;
      goal.limits = limits;
      goal.pole = {0, 1, 0};
      const auto round = [&](int i) { return V(3 * std::sin(0.001 * i), height, 3 * std::cos(0.001 * i)); };
      EXPECT_LT(worst_step(goal, 6300, round), limited ? 3.0 : 1.5) << limited << ' ' << height;
      goal.joints = {&joints.back(), 1};
      EXPECT_LT(worst_step(goal, 6300, round), 0.2) << limited << ' ' << height;
    }
}

TEST(aim, a_target_that_crosses_the_pole_rolls_smoothly) {
  AimGoal goal;
  goal.joints = kHead;
  goal.pole = {0, 1, 0};
  const auto over = [](int i) {  // from +x over the top to -x
    const double angle = 0.001 * i - 1.0;
    return V(0, 0.8, 0) + V(std::sin(angle), std::cos(angle), 0) * 2.0;
  };
  EXPECT_LT(worst_step(goal, 2000, over), 1.0);
}

TEST(aim, refuses_what_it_cannot_aim_and_allocates_nothing) {
  Posed posed = figure();
  AimGoal goal;
  goal.joints = kSpine;
  goal.target = {1, 1, 1};
  const auto code = [&](auto change) {
    AimJob job{&posed.skeleton, posed.pose.span(), goal};
    change(job);
    return check(job);
  };
  const std::array backwards{AimJoint{.joint = 4}, AimJoint{.joint = 2}};
  const std::array unknown{AimJoint{.joint = 9}}, without_limit{AimJoint{.joint = 1, .limit = 0}},
      negative{AimJoint{.joint = 1, .share = -1}};
  EXPECT_EQ(code([](auto&) {}), ErrorCode::ok);
  EXPECT_EQ(code([](auto& job) { job.skeleton = nullptr; }), ErrorCode::size_mismatch);
  EXPECT_EQ(code([](auto& job) { job.goal.joints = {}; }), ErrorCode::unsupported);
  EXPECT_EQ(code([&](auto& job) { job.goal.joints = unknown; }), ErrorCode::index_out_of_range);
  EXPECT_EQ(code([&](auto& job) { job.goal.joints = without_limit; }), ErrorCode::index_out_of_range);
  EXPECT_EQ(code([&](auto& job) { job.goal.joints = backwards; }), ErrorCode::unsupported);
  EXPECT_EQ(code([&](auto& job) { job.goal.joints = negative; }), ErrorCode::negative_weight);
  EXPECT_EQ(code([](auto& job) { job.goal.up = job.goal.forward; }), ErrorCode::unsupported);
  EXPECT_EQ(code([](auto& job) { job.goal.target.y = std::nan(""); }), ErrorCode::not_finite);
  EXPECT_EQ(code([](auto& job) { job.goal.weight = 2.0f; }), ErrorCode::not_a_fraction);
  const AimJob job{&posed.skeleton, posed.pose.span(), goal};
  AllocationCounter counter;
  run_unchecked(job);
  EXPECT_EQ(counter.count(), 0u);
}

}  // namespace
}  // namespace sinew::test
