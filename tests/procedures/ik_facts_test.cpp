// SPDX-License-Identifier: MIT
// Known answers for one limb and one aiming joint, below parents that rotate, scale and mirror. Places are in the space
// of the parent: the solvers work there, so every parent sees the same answers.
#include <gtest/gtest.h>

#include <array>
#include <numbers>
#include <string>

#include "runtime/math/axis_angle.h"
#include "runtime/procedures/aim.h"
#include "tests/procedures/limbs.h"

namespace sinew::test {
namespace {

using V = Vec3<double>;
constexpr float kHalfTurn = std::numbers::pi_v<float>;
const double kHalf = std::sqrt(0.5);

const std::array kParents{
    Transform{},
    Transform{.translation = {0, 1, 0}},
    Transform{.rotation = quat_from_axis_angle(Vec3<float>(1, 2, 3), 1.1f)},
    Transform{.translation = {3, 0, 1}, .rotation = quat_from_axis_angle(Vec3<float>(0, 0, 1), kHalfTurn / 2)},
    Transform{.scale = {2, 2, 2}},
    Transform{.scale = {1, 2, 1}},
    Transform{.scale = {-3, -3, -3}},
    Transform{
        .translation = {1, 2, 3}, .rotation = quat_from_axis_angle(Vec3<float>(3, 0, 1), 2.0f), .scale = {1, -2, 0.5f}},
};

/// Root at the origin, middle joint at (0, 1, 0), tip at (1, 1, 0).
struct LimbFact {
  const char* name;
  V target, pole;  ///< pole: a direction, or zero
  float twist_rad;
  Vec3<float> middle_axis;
  V middle, tip;
  IkStatus status = IkStatus::reached;
};

const LimbFact kLimbFacts[] = {
    {"at the target", {1, 1, 0}, {}, 0, {}, {0, 1, 0}, {1, 1, 0}},
    {"quarter turn", {0, 1, 1}, {0, 1, 0}, 0, {}, {0, 1, 0}, {0, 1, 1}},
    {"half turn", {-1, 1, 0}, {0, 1, 0}, 0, {}, {0, 1, 0}, {-1, 1, 0}},
    {"below", {1, -1, 0}, {0, 1, 0}, 0, {}, {1, 0, 0}, {1, -1, 0}},
    {"pole across", {1, 1, 0}, {0, 0, 1}, 0, {}, {0.5, 0.5, kHalf}, {1, 1, 0}},
    {"pole opposite", {1, 1, 0}, {0, -1, 0}, 0, {}, {1, 0, 0}, {1, 1, 0}},
    {"straight", {2, 0, 0}, {0, 1, 0}, 0, {}, {1, 0, 0}, {2, 0, 0}},
    {"too far", {3, 0, 0}, {0, 1, 0}, 0, {}, {1, 0, 0}, {2, 0, 0}, IkStatus::unreachable},
    {"at the root", {0, 0, 0}, {}, 0, {}, {-kHalf, kHalf, 0}, {0, 0, 0}},
    {"near", {0.2, 0.2, 0}, {}, 0, {}, {0.1 - 0.7, 0.1 + 0.7, 0}, {0.2, 0.2, 0}},
    {"twist of half a turn", {1, 1, 0}, {0, 1, 0}, kHalfTurn, {}, {1, 0, 0}, {1, 1, 0}},
    {"twist of a quarter turn", {1, 1, 0}, {0, 1, 0}, kHalfTurn / 2, {}, {0.5, 0.5, kHalf}, {1, 1, 0}},
    {"pole along the target", {1, 1, 0}, {2, 2, 0}, 0, {}, {0, 1, 0}, {1, 1, 0}},
    {"pole against the target", {1, 1, 0}, {-1, -1, 0}, 0, {}, {0, 1, 0}, {1, 1, 0}},
    {"hinge as bent", {1, 1, 0}, {}, 0, {0, 0, -2}, {0, 1, 0}, {1, 1, 0}},
    {"pole behind a hinge", {-1, 1, 0}, {0, 1, 0}, 0, {0, 0, -1}, {0, 1, 0}, {-1, 1, 0}},
};

TEST(ik_facts, limbs) {
  for (const LimbFact& fact : kLimbFacts)
    for (std::size_t i = 0; i < kParents.size(); ++i) {
      Limb limb(kParents[i], {0, 1, 0}, {1, 0, 0});
      const Affined parent = limb.model(0);
      TwoBoneGoal goal = limb.goal(transform_point(parent, fact.target));
      if (fact.pole != V(0)) {
        goal.pole_kind = PoleKind::direction;
        goal.pole = transform_vector(parent, fact.pole);
      }
      goal.twist_rad = fact.twist_rad;
      goal.middle_axis = fact.middle_axis;
      const IkResult result = limb.solve(goal);
      const std::string where = std::string(fact.name) + ", parent " + std::to_string(i);
      // A straight limb bends by the square root of the rounding of its parent.
      EXPECT_TRUE(is_near(limb.place(2), transform_point(parent, fact.middle), 2e-4)) << where;
      EXPECT_TRUE(is_near(limb.place(3), transform_point(parent, fact.tip), 2e-6)) << where;
      EXPECT_EQ(result.status, fact.status) << where;
    }
}

/// A joint at the origin that looks along x, with up along y.
struct AimFact {
  const char* name;
  V target, pole;
  Vec3<float> forward, up, offset;
  float twist_rad;
  V looks, rises;  ///< expected directions of forward and up
  IkStatus status = IkStatus::reached;
};

const AimFact kAimFacts[] = {
    {"ahead", {5, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {}, 0, {1, 0, 0}, {0, 1, 0}},
    {"behind", {-5, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {}, 0, {-1, 0, 0}, {0, 1, 0}},
    {"left", {0, 0, 2}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {}, 0, {0, 0, 1}, {0, 1, 0}},
    {"right", {0, 0, -2}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {}, 0, {0, 0, -1}, {0, 1, 0}},
    {"backward axis", {5, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 1, 0}, {}, 0, {1, 0, 0}, {0, 1, 0}},
    {"other up", {5, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {}, 0, {1, 0, 0}, {0, 1, 0}},
    {"other pole", {5, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {}, 0, {1, 0, 0}, {0, 0, 1}},
    {"pole down", {5, 0, 0}, {0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {}, 0, {1, 0, 0}, {0, -1, 0}},
    {"no pole", {0, 0, 2}, {}, {1, 0, 0}, {0, 1, 0}, {}, 0, {0, 0, 1}, {0, 1, 0}},
    {"pole along the target", {5, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {}, 0, {1, 0, 0}, {0, 1, 0}},
    {"twist", {5, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {}, kHalfTurn / 2, {1, 0, 0}, {0, 0, 1}},
    {"half twist", {5, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {}, kHalfTurn, {1, 0, 0}, {0, -1, 0}},
    {"offset along", {5, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, 0, {1, 0, 0}, {0, 1, 0}},
    {"offset beside",
     {1, 0, 0},
     {0, 1, 0},
     {1, 0, 0},
     {0, 1, 0},
     {0, 0.70710678f, 0},
     0,
     {kHalf, -kHalf, 0},
     {kHalf, kHalf, 0}},
    {"too close", {0.1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}, 0, {}, {}, IkStatus::unreachable},
};

TEST(ik_facts, aims) {
  for (const AimFact& fact : kAimFacts)
    for (std::size_t i = 0; i < kParents.size(); ++i) {
      Posed posed(chain_skeleton(2));
      posed.set(0, kParents[i]);
      const Affined parent = posed.model(0);
      const std::array joints{AimJoint{.joint = 1}};
      AimGoal goal;
      goal.joints = joints;
      goal.target = transform_point(parent, fact.target);
      goal.pole = transform_vector(parent, fact.pole);
      goal.forward = fact.forward;
      goal.up = fact.up;
      goal.offset = fact.offset;
      goal.twist_rad = fact.twist_rad;
      IkResult result;
      ASSERT_EQ(run(AimJob{&posed.skeleton, posed.pose.span(), goal, &result}), ErrorCode::ok);
      const std::string where = std::string(fact.name) + ", parent " + std::to_string(i);
      EXPECT_EQ(result.status, fact.status) << where;
      if (fact.status != IkStatus::reached) continue;
      const glm::quat turned = posed.get(1).rotation;
      EXPECT_TRUE(is_near(V(rotate_vector(turned, fact.forward)), fact.looks, 2e-6)) << where;
      EXPECT_TRUE(is_near(V(rotate_vector(turned, fact.up)), fact.rises, 2e-6)) << where;
    }
}

}  // namespace
}  // namespace sinew::test
