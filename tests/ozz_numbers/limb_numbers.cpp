// SPDX-License-Identifier: MIT
// Limbs of two bones. A correction is the rotation that ozz multiplies to a joint's own from the right. ozz has no fade
// at the pole, and its middle axis points the other way.
#include <numbers>
#include <optional>
#include <vector>

#include "runtime/math/axis_angle.h"
#include "runtime/procedures/two_bone_ik.h"
#include "tests/ozz_numbers/axes.h"
#include "tests/ozz_numbers/tally.h"
#include "tests/support/tiny_assets.h"

namespace sinew::ozz {
namespace {

using Turn = Quat<double>;
constexpr double kLimbTolerance = 2e-3;  // the tolerance of ozz
const Turn kSame = quat_identity<double>();

constexpr const char* kOutOfRange = "TwoBoneIkJob refuses weights and shares outside of their ranges";

constexpr const char* kKeepsTip = "a target at the root keeps the direction of the tip from there";

Turn about(const V& axis, double angle) { return quat_from_axis_angle(axis, angle); }

struct LimbCase {
  V target{1, 1, 0};
  std::optional<Turn> start = kSame, middle = kSame;  ///< corrections; nullopt: ozz expects no numbers
  int reached = 1;                                    ///< -1: ozz does not look at it
  V pole{0, 1, 0};
  double twist = 0.0, weight = 1.0, soften = 1.0;
  bool other_side = false;  ///< the middle axis of ozz is negated
  const char* rule = nullptr;
};

/// Three joints below a parent: a bone along y, and from its end a bone to `tip`.
struct Limb {
  Transform parent, middle{.translation = {0, 1, 0}, .rotation = quat_cast<float>(about(kZ, kPi / 2))},
      tip{.translation = {0, -1, 0}};
};

void compare_correction(const glm::quat& before, const glm::quat& after, const std::optional<Turn>& expected,
                        Tally& tally, const char* rule) {
  if (!expected) return;
  const Turn found = quat_conjugate(quat_cast<double>(before)) * quat_cast<double>(after);
  compare_rotation(found, *expected, tally, rule, kLimbTolerance);
}

void compare_limb(const Limb& limb, const LimbCase& c, Tally& tally) {
  const Skeleton skeleton = test::skeleton_of({kNone, 0, 1, 2});
  test::PoseBuffer pose(4);
  pose.span().set(0, limb.parent);
  pose.span().set(2, limb.middle);
  pose.span().set(3, limb.tip);
  IkResult result;
  const TwoBoneGoal goal{.root = 1,
                         .middle = 2,
                         .tip = 3,
                         .target = c.target,
                         .pole = c.pole,
                         .pole_kind = PoleKind::direction,
                         .middle_axis = Vec3<float>(0, 0, c.other_side ? 1 : -1),
                         .twist_rad = static_cast<float>(c.twist),
                         .weight = static_cast<float>(c.weight),
                         .soft_reach = static_cast<float>(1.0 - c.soften),
                         .pole_fade = 0.0f};
  const ErrorCode code = run(TwoBoneIkJob{&skeleton, pose.span(), goal, nullptr, &result});
  if (code != ErrorCode::ok) {
    EXPECT_EQ(c.rule, kOutOfRange) << describe(code);
    tally.by_rule += 4 * (c.start.has_value() + c.middle.has_value()) + (c.reached >= 0);
    return;
  }
  compare_correction({1, 0, 0, 0}, pose.span().get(1).rotation, c.start, tally, c.rule);
  compare_correction(limb.middle.rotation, pose.span().get(2).rotation, c.middle, tally, c.rule);
  if (c.reached >= 0)  // ozz reaches within 0.01
    compare(result.status != IkStatus::idle && result.metres_left < 1e-2f, c.reached, 0.0, tally, c.rule);
}

Tally tally_of_limbs(const Limb& limb, const std::vector<LimbCase>& cases) {
  Tally tally;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    SCOPED_TRACE(i);
    compare_limb(limb, cases[i], tally);
  }
  return tally;
}

}  // namespace

Tally limb_corrections_group() {
  const Transform parents[] = {{},
                               {.translation = {0, 1, 0}},
                               {.rotation = quat_cast<float>(about(kY, kPi / 3))},
                               {.scale = {2, 2, 2}},
                               {.scale = {1, 2, 1}},
                               {.scale = {-3, -3, -3}}};
  Tally tally;
  for (const Transform& parent : parents) {
    SCOPED_TRACE(&parent - parents);
    const AffineT<double> model =
        affine_from_transform(Transformd{V(parent.translation), quat_cast<double>(parent.rotation), V(parent.scale)});
    std::vector<LimbCase> cases{{.target = V(1, 1, 0)},
                                {.target = V(0, 1, 1), .start = about(kY, -kPi / 2)},
                                {.target = V(0, 1, -1), .start = about(kY, kPi / 2)}};
    for (LimbCase& c : cases) {
      c.target = transform_point(model, c.target);
      c.pole = transform_vector(model, kY);
    }
    tally += tally_of_limbs({.parent = parent}, cases);
  }
  return tally;
}

Tally limb_poles_group() {
  const double diagonal = std::sqrt(0.5);
  return tally_of_limbs({}, {{},
                             {.target = V(1, 0, 1), .start = about(kX, kPi / 2), .pole = kZ},
                             {.target = V(1, 0, -1), .start = about(kX, -kPi / 2), .pole = -kZ},
                             {.target = V(1, -1, 0), .start = about(kZ, -kPi / 2), .pole = kX},
                             {.target = V(-1, 1, 0), .start = about(kZ, kPi / 2), .pole = -kX},
                             // Twist
                             {},
                             {.start = about(V(diagonal, diagonal, 0), kPi / 2), .twist = kPi / 2},
                             {.start = about(V(diagonal, diagonal, 0), -kPi), .twist = kPi},
                             {.twist = 2.0 * kPi},
                             // PoleTargetAlignment
                             {.target = V(0, std::numbers::sqrt2, 0), .start = {}},
                             {.target = V(0.001, std::numbers::sqrt2, 0), .start = about(kZ, kPi / 4)},
                             {.target = V(0, 3, 0), .start = {}, .middle = about(kZ, kPi / 2), .reached = -1}});
}

Tally limb_reach_group() {
  const Turn start = about(kZ, -kPi / 2), middle = about(kZ, kPi / 2);
  return tally_of_limbs(
      {},
      {// Soften
       {.target = V(2, 0, 0), .start = start, .middle = middle},
       {.target = V(1, 0, 0), .start = {}, .middle = {}, .soften = 0.5},
       {.target = V(0.8, 0, 0), .start = {}, .middle = {}, .soften = 0.5},
       {.target = V(1.2, 0, 0), .start = {}, .middle = {}, .reached = 0, .soften = 0.5},
       {.target = V(1.2, 0, 0), .start = {}, .middle = {}, .reached = 0, .soften = 0.0, .rule = kOutOfRange},
       {.target = V(2, 0, 0), .start = {}, .middle = {}, .reached = 0, .soften = 0.5},
       {.target = V(3, 0, 0), .start = {}, .middle = {}, .reached = 0},
       // Weight
       {.target = V(2, 0, 0), .start = start, .middle = middle},
       {.target = V(2, 0, 0), .start = start, .middle = middle, .weight = 1.1, .rule = kOutOfRange},
       {.target = V(2, 0, 0), .reached = 0, .weight = 0.0},
       {.target = V(2, 0, 0), .reached = 0, .weight = -0.1, .rule = kOutOfRange},
       {.target = V(2, 0, 0), .start = about(kZ, -kPi / 4), .middle = about(kZ, kPi / 4), .reached = 0, .weight = 0.5},
       // ZeroLengthStartTarget
       {.target = V(0.0), .middle = about(kZ, -kPi / 2), .reached = -1, .rule = kKeepsTip}});
}

Tally limb_shapes_group() {
  // MidAxis
  Tally tally = tally_of_limbs({}, {{}, {.start = about(kY, kPi), .middle = about(kZ, kPi), .other_side = true}});
  tally += tally_of_limbs({.tip = {.translation = {1, 0, 0}}}, {{.middle = about(kZ, -kPi / 2)}});
  // AlignedJointsAndTarget
  const Limb straight{.middle = {.translation = {1, 0, 0}}, .tip = {.translation = {1, 0, 0}}};
  tally += tally_of_limbs(straight, {{.target = V(2, 0, 0)}, {.target = V(3, 0, 0), .reached = 0}});
  // ZeroScale, ZeroLengthBoneChain
  tally += tally_of_limbs({.parent = {.scale = {0, 0, 0}}}, {{.target = V(0.0), .reached = -1}});
  const Limb point{.middle = {}, .tip = {}};
  tally += tally_of_limbs(point, {{.target = kX, .start = {}, .middle = {}, .reached = 0}});
  return tally;
}

}  // namespace sinew::ozz
