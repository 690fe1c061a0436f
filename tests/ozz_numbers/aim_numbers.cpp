// SPDX-License-Identifier: MIT
// A joint that aims at a target. The joint has no rotation of its own, so what sinew writes is the correction of ozz.
#include <array>
#include <vector>

#include "runtime/math/axis_angle.h"
#include "runtime/procedures/aim.h"
#include "tests/ozz_numbers/axes.h"
#include "tests/ozz_numbers/tally.h"
#include "tests/support/tiny_assets.h"

namespace sinew::ozz {
namespace {

constexpr double kAimTolerance = 2e-3;  // the tolerance of ozz

constexpr const char* kRefused = "AimJob refuses directions without length and weights outside of [0, 1]";
constexpr const char* kUnreachable = "no turn reaches the target: AimJob turns all the same, ozz does not";
constexpr const char* kNoRoll = "AimJob rolls in any way if `up` points along the line that turns";

struct AimCase {
  V target{0.0};
  V axis{1, 0, 0};     ///< the turn that ozz expects
  double angle = 0.0;  ///< radians
  V forward{1, 0, 0}, up{0, 1, 0}, pole{0, 1, 0}, offset{0.0};
  double twist = 0.0, weight = 1.0;
  const char* rule = nullptr;  ///< set where sinew may give other numbers, or refuse the goal
};

/// Counts the four numbers of the correction.
/// in   parent  the joint's matrix in model space;   the target and the pole of `c` are in model space
void compare_aim(const AimCase& c, const Transform& parent, Tally& tally) {
  const Skeleton skeleton = test::skeleton_of({kNone, 0});
  test::PoseBuffer pose(2);
  pose.span().set(0, parent);
  const std::array joints{AimJoint{.joint = 1}};
  const AimGoal goal{.joints = joints,
                     .target = c.target,
                     .forward = Vec3<float>(c.forward),
                     .up = Vec3<float>(c.up),
                     .offset = Vec3<float>(c.offset),
                     .pole = c.pole,
                     .twist_rad = static_cast<float>(c.twist),
                     .weight = static_cast<float>(c.weight)};
  const ErrorCode code = run(AimJob{&skeleton, pose.span(), goal});
  if (code != ErrorCode::ok) {
    EXPECT_EQ(c.rule, kRefused) << describe(code);
    tally.by_rule += 4;
    return;
  }
  const glm::quat found = pose.span().get(1).rotation,
                  expected = quat_cast<float>(quat_from_axis_angle(c.axis, c.angle));
  compare_rotation(found, expected, tally, c.rule, kAimTolerance);
}

Tally tally_of_aims(const std::vector<AimCase>& cases, const Transform& parent = {}) {
  Tally tally;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    SCOPED_TRACE(i);
    compare_aim(cases[i], parent, tally);
  }
  return tally;
}

}  // namespace

Tally aim_corrections_group() {
  const Transform parents[] = {{},
                               {.translation = {0, 1, 0}},
                               {.rotation = quat_cast<float>(quat_from_axis_angle(kY, kPi / 3))},
                               {.scale = {2, 2, 2}},
                               {.scale = {1, 2, 1}},
                               {.scale = {-3, -3, -3}}};
  Tally tally;
  for (const Transform& parent : parents) {
    SCOPED_TRACE(&parent - parents);
    const AffineT<double> model =
        affine_from_transform(Transformd{V(parent.translation), quat_cast<double>(parent.rotation), V(parent.scale)});
    std::vector<AimCase> cases{{kX},
                               {.target = -kX, .axis = kY, .angle = kPi},
                               {kZ, kY, -kPi / 2},
                               {-kZ, kY, kPi / 2},
                               {V(1, 1, 0), kZ, kPi / 4},
                               {V(2, 2, 0), kZ, kPi / 4}};
    for (AimCase& c : cases) {
      c.target = transform_point(model, c.target);
      c.pole = transform_vector(model, kY);
    }
    tally += tally_of_aims(cases, parent);
  }
  return tally;
}

Tally aim_directions_group() {
  return tally_of_aims({{kX},
                        {.target = kX, .axis = kY, .angle = -kPi, .forward = -kX},
                        {kX, kY, kPi / 2, kZ},
                        // Up
                        {kX},
                        {.target = kX, .angle = kPi, .up = -kY},
                        {.target = kX, .angle = -kPi / 2, .up = kZ},
                        {.target = kX, .angle = -kPi / 2, .up = 2.0 * kZ},
                        {.target = kX, .angle = -kPi / 2, .up = 1e-9 * kZ},
                        {.target = kX, .up = V(0.0), .rule = kRefused},
                        // Pole
                        {kX},
                        {.target = kX, .angle = kPi, .pole = -kY},
                        {.target = kX, .angle = kPi / 2, .pole = kZ},
                        {.target = kX, .angle = kPi / 2, .pole = 2.0 * kZ},
                        {.target = kX, .angle = kPi / 2, .pole = 1e-9 * kZ},
                        // Twist
                        {kX},
                        {.target = kX, .angle = kPi / 2, .twist = kPi / 2},
                        {.target = kX, .angle = -kPi / 2, .twist = -kPi / 2}});
}

Tally aim_offsets_group() {
  Tally tally = tally_of_aims({{kX},
                               {.target = kX, .axis = kZ, .angle = -kPi / 4, .offset = V(0, std::sqrt(0.5), 0)},
                               {.target = kX, .axis = kZ, .angle = -kPi / 6, .offset = V(0.5, 0.5, 0)},
                               {.target = kX, .axis = kZ, .angle = -kPi / 6, .offset = V(-0.5, 0.5, 0)},
                               {.target = kX, .axis = kY, .angle = kPi / 6, .offset = V(0.5, 0, 0.5)},
                               {.target = kX, .axis = kZ, .angle = -kPi / 2, .offset = kY, .rule = kNoRoll},
                               {.target = kX, .offset = 2.0 * kY, .rule = kUnreachable}});
  tally += tally_of_aims({{.target = kX, .axis = kZ, .angle = -kPi / 2, .offset = kY}}, {.translation = {0, 1, 0}});
  return tally;
}

Tally aim_limits_group() {
  return tally_of_aims({{kX},
                        {kY, kZ, kPi / 2},
                        {2.0 * kY, kZ, kPi / 2},
                        {-2.0 * kY, kZ, -kPi / 2},
                        {kX},
                        {kY, kZ, kPi / 2},
                        {V(0.0)},
                        // Weight
                        {kZ, kY, -kPi / 2},
                        {.target = kZ, .axis = kY, .angle = -kPi / 2, .weight = 2.0, .rule = kRefused},
                        {.target = kZ, .axis = kY, .angle = -kPi / 4, .weight = 0.5},
                        {.target = kZ, .weight = 0.0},
                        {.target = kZ, .weight = -0.5, .rule = kRefused}});
}

}  // namespace sinew::ozz
