// SPDX-License-Identifier: MIT
// An arm that plays a clip and reaches for a goal. Two clips are overlaid by a mask, then the caller's inverse
// kinematics turn the arm, all in one pose program. The second way is a cut: the frame stops at its pose, the caller
// turns the arm, and the frame goes on.
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "runtime/math/axis_angle.h"
#include "runtime/math/two_bones.h"
#include "runtime/plan/cut_frame.h"
#include "samples/showcase/scene_builder.h"

namespace {

using namespace sinew;

enum Joint : std::uint32_t { kChest, kShoulder, kElbow, kHand, kJointCount };

/// A joint that swings about `axis` by `angle_rad` to both sides, once a second.
BoneAnimation swing(Joint joint, const glm::vec3& axis, float angle_rad) {
  BoneAnimation bone;
  bone.joint = joint;
  bone.rotation.times_s = {0.0f, 0.25f, 0.75f, 1.0f};
  for (const float angle : {0.0f, angle_rad, -angle_rad, 0.0f})
    bone.rotation.values.push_back(quat_from_axis_angle(axis, angle));
  return bone;
}

Scene make_arm() {
  showcase::SceneBuilder scene;
  scene.add_joint("chest", kNone, {.translation = {0, 1.4f, 0}});
  scene.add_joint("shoulder", kChest, {.translation = {0.2f, 0, 0}});
  scene.add_joint("elbow", kShoulder, {.translation = {0, -0.3f, 0}});
  scene.add_joint("hand", kElbow, {.translation = {0, -0.25f, 0}});
  scene.add_animation({"breathe", 1.0, {swing(kChest, {1, 0, 0}, 0.1f), swing(kShoulder, {0, 0, 1}, 0.05f)}, {}});
  scene.add_animation({"wave", 1.0, {swing(kShoulder, {1, 0, 0}, 0.6f), swing(kElbow, {1, 0, 0}, 0.4f)}, {}});
  return scene.finish();
}

glm::vec3 place_of(const Affine& matrix) { return {matrix.row[0].w, matrix.row[1].w, matrix.row[2].w}; }

/// Turns shoulder and elbow so that the hand reaches a goal. A share below 1 turns them by only a part of the way.
void reach(const PoseSpan& local, const glm::vec3& goal, float share) {
  Affine model[kJointCount];
  glm::quat turned[kJointCount];  // rotations in model space
  for (std::uint32_t j = 0; j < kJointCount; ++j) {
    const Transform t = local.get(j);
    model[j] = j == 0 ? affine_from_transform(t) : model[j - 1] * affine_from_transform(t);
    turned[j] = j == 0 ? t.rotation : turned[j - 1] * t.rotation;
  }
  const glm::vec3 hand = place_of(model[kHand]);
  const TwoBonesT<float> limb{place_of(model[kShoulder]), place_of(model[kElbow]), hand};
  const TwoBoneTurnsT<float> turns = turn_two_bones(limb, glm::mix(hand, goal, share), glm::vec3(0, 0, -1), 0.0f);
  const glm::quat shoulder = turns.upper * turned[kShoulder], elbow = turns.lower * turned[kElbow];
  local.set_rotation(kShoulder, glm::normalize(glm::conjugate(turned[kChest]) * shoulder));
  local.set_rotation(kElbow, glm::normalize(glm::conjugate(shoulder) * elbow));
}

void run_reach(void* goal, const ProcedurePose& pose) { reach(pose.local, *static_cast<glm::vec3*>(goal), pose.share); }

}  // namespace

int main(int argc, char** argv) {
  double share = 1.0;
  if (argc > 1) {
    const char* const end = argv[1] + std::strlen(argv[1]);
    const auto [stop, error] = std::from_chars(argv[1], end, share);
    if (argc > 2 || error != std::errc{} || stop != end || !(share >= 0.0 && share <= 1.0)) {
      std::fprintf(stderr, "usage: reach_a_goal [share of the way, 0 to 1]\n");
      return 2;
    }
  }
  Needs needs;
  needs.in.masks = {{0, 1, 1, 1}};  // the arm without the chest
  needs.in.program = {.ops = 4, .slots = 2, .masks = 1, .procedures = 1};
  needs.in.cut = true;
  const Plan plan = compile_plan(make_arm(), needs);
  FrameBuffer by_procedure(plan), by_cut(plan), without(plan);
  for (int step = 0; step < 8; ++step) {
    const double time_s = 0.125 * step;
    glm::vec3 goal(0.35f, 1.2f + 0.05f * static_cast<float>(step), 0.25f);

    PoseProgram program;
    program.sample(0, time_s).sample(1, time_s, 1.0f, 0).overlay().procedure(0, share);
    const PoseProcedure procedure{&run_reach, &goal, 0};
    FrameInput input;
    input.program = program.ops();
    input.program_inputs.procedures = {&procedure, 1};
    if (run_plan(plan, input, by_procedure) != ErrorCode::ok) return 1;

    program.clear();
    program.sample(0, time_s).sample(1, time_s, 1.0f, 0).overlay();
    const FrameInput playing{.layers = {}, .weights = {}, .root = {}, .program = program.ops()};
    CutPose pose;
    if (run_plan(plan, playing, without) != ErrorCode::ok) return 1;
    if (run_to_cut(plan, playing, by_cut, pose) != ErrorCode::ok) return 1;
    if (share > 0.0) reach(pose.local, goal, static_cast<float>(share));
    if (run_from_cut(plan, playing, by_cut) != ErrorCode::ok) return 1;

    const glm::vec3 start = place_of(without.result().model[kHand]),
                    hand = place_of(by_procedure.result().model[kHand]), other = place_of(by_cut.result().model[kHand]);
    const glm::vec3 wanted = glm::mix(start, goal, static_cast<float>(share));
    std::printf("%5.3f s   hand at %6.3f %6.3f %6.3f, %.1e m from where it is wanted\n", time_s,
                static_cast<double>(hand.x), static_cast<double>(hand.y), static_cast<double>(hand.z),
                static_cast<double>(glm::distance(hand, wanted)));
    if (glm::distance(hand, wanted) > 2e-6f || hand != other) {
      std::fprintf(stderr, "the hand is not where it is wanted\n");
      return 1;
    }
  }
  return 0;
}
