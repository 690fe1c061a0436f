// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "runtime/math/axis_angle.h"
#include "runtime/plan/run_plan.h"
#include "runtime/pose/pose_memory.h"
#include "tests/scenes/random_scene.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {

inline constexpr PoseProgramRoom kProgramSceneRoom{.ops = 24,
                                                   .slots = 6,
                                                   .externals = 1,
                                                   .overrides = 1,
                                                   .masks = 3,
                                                   .procedures = 1,
                                                   .overridden_joints = 4,
                                                   .overlays_in_model_space = true};

/// A scene, a plan whose frames may be anything, and a pose, a joint and a mask of the caller.
struct ProgramScene {
  Scene scene;
  Plan plan;
  PoseMemory pose_memory;
  std::vector<float> pose_weights, mask_weights;
  ExternalPose external;
  JointOverride joint;
  JointOverrides overrides;
  PoseMask mask;

  explicit ProgramScene(std::uint64_t seed, bool cut = false)
      : scene(random_scene(seed)), plan(lend_plan(scene, cut)), pose_memory(scene.skeleton.joint_count()) {
    FixedRandom random(seed + 50);
    for (std::size_t j = 0; j < scene.skeleton.joint_count(); ++j) {
      Transform t = scene.skeleton.rest[j];
      t.rotation = random.rotation_by(0.5) * t.rotation;
      pose_memory.span().set(j, t);
      mask_weights.push_back(j % 2 == 0 ? 1.0f : 0.25f);
    }
    for (std::size_t w = 0; w < scene.weight_count(); ++w) pose_weights.push_back(static_cast<float>(random.unit()));
    external = {pose_memory.span(), pose_weights, {}, 1};
    const auto last = static_cast<std::uint32_t>(scene.skeleton.joint_count() - 1);
    joint = {last, {{0.5f, 1, -2}, quat_cast<float>(quat_from_axis_angle(Vec3<double>(1, 0, 0), 0.8)), {1, 1, 1}}};
    overrides = {{&joint, 1}, 1};
    mask = {.joints = mask_weights, .version = 1};
  }

  static Plan lend_plan(const Scene& scene, bool cut) {
    Needs needs{.out = {.palettes = true, .bounds = true}};
    needs.in.additive = true;
    needs.in.masks = {std::vector<float>(scene.skeleton.joint_count(), 0.5f)};
    needs.in.program = kProgramSceneRoom;
    needs.in.cut = cut;
    return compile_plan(lend(scene), needs);
  }
  FrameInput input(const PoseProgram& program) const {
    FrameInput input;
    input.program = program.ops();
    input.program_inputs = {.externals = {&external, 1}, .overrides = {&overrides, 1}, .masks = {&mask, 1}};
    return input;
  }
};

}  // namespace sinew::test
