// SPDX-License-Identifier: MIT
// A figure walks up stairs with a clip that was made for flat ground. Feet are a procedure of its pose program: the
// soles lie on the steps, the pelvis comes along, and a foot stays where it stands.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <numbers>

#include "runtime/plan/run_plan.h"
#include "runtime/pose/pose_memory.h"
#include "runtime/procedures/feet.h"
#include "runtime/procedures/two_bone_ik.h"
#include "samples/showcase/scene_builder.h"

namespace {

using namespace sinew;

enum Joint : std::uint32_t { kHips, kThighLeft, kThighRight, kShinLeft, kShinRight, kFootLeft, kFootRight };

/// Two legs with slightly bent knees, which walk along +z.
Scene make_legs() {
  showcase::SceneBuilder scene;
  scene.add_joint("hips", kNone, {.translation = {0, 0.97f, 0}});
  scene.add_joint("left thigh", kHips, {.translation = {0.1f, 0, 0}});
  scene.add_joint("right thigh", kHips, {.translation = {-0.1f, 0, 0}});
  scene.add_joint("left shin", kThighLeft, {.translation = {0, -0.46f, 0.04f}});
  scene.add_joint("right shin", kThighRight, {.translation = {0, -0.46f, 0.04f}});
  scene.add_joint("left foot", kShinLeft, {.translation = {0, -0.43f, -0.04f}});
  scene.add_joint("right foot", kShinRight, {.translation = {0, -0.43f, -0.04f}});
  return scene.finish();
}

constexpr double kStep_m = 0.6, kCycle_s = 1.2;  // a foot stands for 0.6 of a cycle, in which the body goes one step
constexpr double kSpeed_m_s = kStep_m / (0.6 * kCycle_s), kTread_m = kSpeed_m_s * kCycle_s / 2;  // a foot on each tread
constexpr double kAnkle_m = 0.08;
constexpr std::array kSide_m{0.1, -0.1}, kPhase{0.0, 0.5};  // of the left and the right foot

/// Place of an ankle in the clip, with the character at the origin.
Vec3<double> ankle_in_clip(double time_s, std::size_t side) {
  double at = time_s / kCycle_s + kPhase[side];
  at -= std::floor(at);
  const double stands = 0.6;
  if (at < stands) return {kSide_m[side], kAnkle_m, kStep_m * (0.5 - at / stands)};
  const double air = (at - stands) / (1.0 - stands);
  return {kSide_m[side], kAnkle_m + 0.1 * std::sin(air * std::numbers::pi),
          kStep_m * (-0.5 + air * air * (3.0 - 2.0 * air))};
}

/// The clip: hips a little low, and both feet where ankle_in_clip() has them. An engine samples a clip instead.
void walk_on_flat_ground(const Skeleton& skeleton, const PoseSpan& pose, double time_s) {
  for (std::uint32_t j = 0; j < skeleton.joint_count(); ++j) pose.set(j, skeleton.rest[j]);
  Transform hips = skeleton.rest[kHips];
  hips.translation.y -= 0.09f;
  pose.set(kHips, hips);
  for (std::uint32_t side = 0; side < 2; ++side) {
    TwoBoneIkJob leg{.skeleton = &skeleton, .local = pose, .goal = {}};
    leg.goal.root = kThighLeft + side;
    leg.goal.middle = kShinLeft + side;
    leg.goal.tip = kFootLeft + side;
    leg.goal.target = ankle_in_clip(time_s, side);
    leg.goal.end = EndRotation::given;  // the soles stay level
    (void)run(leg);
  }
}

/// Each foot lands in the middle of a tread.
struct Stairs {
  double rise_m = 0.0;
  double height(double z) const { return rise_m * std::floor(z / kTread_m - 0.1); }
  static bool find(void* context, std::size_t, const Vec3<double>& place, GroundHit& hit) {
    hit.height_m = static_cast<const Stairs*>(context)->height(place.z);
    return true;
  }
};

}  // namespace

int main(int argc, char** argv) {
  Stairs stairs{0.18};
  if (argc > 1) {
    const char* const end = argv[1] + std::strlen(argv[1]);
    const auto [stop, error] = std::from_chars(argv[1], end, stairs.rise_m);
    if (argc > 2 || error != std::errc{} || stop != end || !(std::abs(stairs.rise_m) <= 0.2)) {
      std::fprintf(stderr, "usage: stand_on_stairs [rise of a step in metres, -0.2 to 0.2]\n");
      return 2;
    }
  }
  const Scene scene = make_legs();
  const Skeleton& skeleton = scene.skeleton;
  Needs needs;
  needs.out.local_pose = true;
  needs.in.program = {.ops = 2, .slots = 1, .externals = 1, .procedures = 1};
  const Plan plan = compile_plan(lend(scene), needs);
  FrameBuffer frame(plan);
  PoseMemory clip(skeleton.joint_count());

  std::array<FootSetup, 2> legs;
  for (std::uint32_t side = 0; side < 2; ++side) {
    legs[side] = foot_on_rest_ground(skeleton, kThighLeft + side, kShinLeft + side, kFootLeft + side);
    legs[side].tip.z += 0.12f;  // the ball of the foot, before the ankle
  }
  Feet feet;
  feet.setup.pelvis = kHips;
  feet.setup.feet = legs;
  feet.ground = {&Stairs::find, &stairs};

  constexpr double kFps = 60.0;
  double worst_m = 0.0, without_m = 0.0;
  int standing = 0;
  for (int step = 0; step <= static_cast<int>(4 * kCycle_s * kFps); ++step) {
    const double time_s = step / kFps;
    walk_on_flat_ground(skeleton, clip.span(), time_s);
    feet.dt_s = step == 0 ? 0.0 : 1.0 / kFps;
    feet.root.row[2].w = kSpeed_m_s * time_s;
    feet.root.row[1].w = stairs.rise_m * (feet.root.row[2].w / kTread_m - 0.5);  // a capsule slides up the stairs
    const ExternalPose external{.pose = clip.span()};
    const PoseProcedure procedure = as_procedure(feet);
    PoseProgram program;
    program.external(0).procedure(0);
    FrameInput input;
    input.root = affine_cast<float>(feet.root);
    input.program = program.ops();
    input.program_inputs.externals = {&external, 1};
    input.program_inputs.procedures = {&procedure, 1};
    if (run_plan(plan, input, frame) != ErrorCode::ok || feet.error != ErrorCode::ok) return 1;
    for (std::uint32_t side = 0; side < 2; ++side) {
      const auto is_down = [&](double when_s) { return ankle_in_clip(when_s, side).y <= kAnkle_m; };
      if (!is_down(time_s) || !is_down(time_s - 0.15)) continue;  // it stands, and not only just
      ++standing;
      worst_m = std::max(worst_m, std::abs(static_cast<double>(feet.results[side].tip_above_ground_m)));
      without_m = std::max(without_m, std::abs(feet.root.row[1].w - stairs.height(feet.state.feet[side].shown_tip.z)));
    }
    if (step % 12 == 0)
      std::printf("%4.1f s: hips %5.2f m, left foot %s at %5.2f m, right foot %s at %5.2f m\n", time_s,
                  feet.root.row[1].w + static_cast<double>(frame.result().local.get(kHips).translation.y),
                  feet.results[0].is_locked ? "stands" : "swings", feet.state.feet[0].shown_tip.y,
                  feet.results[1].is_locked ? "stands" : "swings", feet.state.feet[1].shown_tip.y);
  }
  std::printf("feet that stand are at most %.1f mm from their steps; those of the clip alone %.0f mm\n", 1e3 * worst_m,
              1e3 * without_m);
  if (standing < 100 || worst_m > 0.01) {
    std::fprintf(stderr, "the feet do not stand on the stairs\n");
    return 1;
  }
  return 0;
}
