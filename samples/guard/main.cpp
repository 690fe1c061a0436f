// SPDX-License-Identifier: MIT
// A guard stands on a slope and looks at you. Three procedures of one pose program: each foot is put on the ground, and
// spine, neck and head turn to a visitor who walks past. Nobody wrote a clip for it.
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <numbers>

#include "runtime/math/axis_angle.h"
#include "runtime/plan/run_plan.h"
#include "runtime/procedures/procedure.h"
#include "samples/showcase/scene_builder.h"

namespace {

using namespace sinew;

enum Joint : std::uint32_t {
  kHips,
  kSpine,
  kThighLeft,
  kThighRight,
  kNeck,
  kShinLeft,
  kShinRight,
  kHead,
  kFootLeft,
  kFootRight,
};

/// A figure of sticks with slightly bent knees, which looks along +z.
Scene make_guard() {
  showcase::SceneBuilder scene;
  scene.add_joint("hips", kNone, {.translation = {0, 0.9f, 0}});
  scene.add_joint("spine", kHips, {.translation = {0, 0.2f, 0}});
  scene.add_joint("left thigh", kHips, {.translation = {0.12f, 0, 0}});
  scene.add_joint("right thigh", kHips, {.translation = {-0.12f, 0, 0}});
  scene.add_joint("neck", kSpine, {.translation = {0, 0.35f, 0}});
  scene.add_joint("left shin", kThighLeft, {.translation = {0, -0.46f, 0.05f}});
  scene.add_joint("right shin", kThighRight, {.translation = {0, -0.46f, 0.05f}});
  scene.add_joint("head", kNeck, {.translation = {0, 0.15f, 0}});
  scene.add_joint("left foot", kShinLeft, {.translation = {0, -0.46f, -0.05f}});
  scene.add_joint("right foot", kShinRight, {.translation = {0, -0.46f, -0.05f}});
  return scene.finish();
}

constexpr double kAnkle_m = 0.05;  ///< above the sole

/// Height of the ground, which rises to the left of the guard.
double ground(double x, double slope_rad) { return x * std::tan(slope_rad) - 0.02; }

TwoBoneIk foot_on_ground(Joint thigh, Joint shin, Joint foot, double x, double slope_rad) {
  TwoBoneIk ik;
  ik.goal.root = thigh;
  ik.goal.middle = shin;
  ik.goal.tip = foot;
  ik.goal.target = {x, ground(x, slope_rad) + kAnkle_m / std::cos(slope_rad), 0};
  ik.goal.end = EndRotation::given;  // the sole lies on the slope
  ik.goal.end_rotation = quat_from_axis_angle(Vec3<float>(0, 0, 1), static_cast<float>(slope_rad));
  ik.goal.pole_kind = PoleKind::tip_axis;
  ik.goal.pole = {0, 0, 1};  // the knee follows the foot
  return ik;
}

/// A neck and a head turn to the sides more than they nod.
JointLimit turn_of_head() {
  JointLimit limit;
  limit.axes = quat_from_axis_angle(Vec3<float>(0, 0, 1), std::numbers::pi_v<float> / 2);  // its x is up
  limit.swing_y_rad = limit.swing_z_rad = 0.5f;
  limit.least_twist_rad = -0.8f;
  limit.most_twist_rad = 0.8f;
  return limit;
}

const char* name_of(IkStatus status) {
  constexpr const char* kNames[] = {"idle", "reached", "limited", "unreachable"};
  return kNames[static_cast<std::size_t>(status)];
}

}  // namespace

int main(int argc, char** argv) {
  double slope_deg = 15.0;
  if (argc > 1) {
    const char* const end = argv[1] + std::strlen(argv[1]);
    const auto [stop, error] = std::from_chars(argv[1], end, slope_deg);
    if (argc > 2 || error != std::errc{} || stop != end || !(std::abs(slope_deg) <= 20.0)) {
      std::fprintf(stderr, "usage: guard [slope in degrees, -20 to 20]\n");
      return 2;
    }
  }
  const double slope_rad = slope_deg * std::numbers::pi / 180.0;
  Needs needs;
  needs.in.program = {.ops = 2, .slots = 1, .procedures = 1};
  const Plan plan = compile_plan(make_guard(), needs);
  FrameBuffer frame(plan);

  TwoBoneIk left = foot_on_ground(kThighLeft, kShinLeft, kFootLeft, 0.15, slope_rad);
  TwoBoneIk right = foot_on_ground(kThighRight, kShinRight, kFootRight, -0.15, slope_rad);
  const std::array joints{AimJoint{.joint = kSpine, .share = 0.2f, .limit = 0},
                          AimJoint{.joint = kNeck, .share = 0.3f, .limit = 0},
                          AimJoint{.joint = kHead, .share = 0.5f, .limit = 0}};
  const std::array limits{turn_of_head()};
  AimIk look;
  look.goal.joints = joints;
  look.goal.limits = limits;
  look.goal.pole = {0, 1, 0};

  for (int step = 0; step <= 8; ++step) {
    const double angle = (step - 4) * std::numbers::pi / 4;  // from behind, past the front, and round again
    look.goal.target = {3 * std::sin(angle), 1.7, 3 * std::cos(angle)};
    const std::array all{as_procedure(left), as_procedure(right), as_procedure(look)};
    ProcedureList list{all};
    const PoseProcedure procedure = as_procedure(list);
    PoseProgram program;
    program.rest().procedure(0);
    FrameInput input;
    input.program = program.ops();
    input.program_inputs.procedures = {&procedure, 1};
    if (run_plan(plan, input, frame) != ErrorCode::ok) return 1;
    std::printf("visitor at %4.0f degrees: %s, %4.1f degrees left; feet %.0e and %.0e m from the ground\n",
                angle * 180.0 / std::numbers::pi, name_of(look.result.status),
                static_cast<double>(look.result.radians_left) * 180.0 / std::numbers::pi,
                static_cast<double>(left.result.metres_left), static_cast<double>(right.result.metres_left));
    const bool feet = left.result.status == IkStatus::reached && right.result.status == IkStatus::reached;
    // Spine, neck and head turn by 0.8 rad each, a little more where they lean.
    const bool sees = std::abs(angle) > 2.3 || look.result.status == IkStatus::reached;
    if (!feet || !sees) {
      std::fprintf(stderr, "the guard %s\n", feet ? "does not look at the visitor" : "does not stand on the ground");
      return 1;
    }
  }
  return 0;
}
