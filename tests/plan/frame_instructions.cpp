// SPDX-License-Identifier: MIT
// Runs frames of a scene with COUNT unused effects, COUNT nodes that no clip moves, and COUNT joints that the plan
// leaves out. Callgrind counts their instructions:
//   sinew-frame-instructions COUNT
#include <valgrind/callgrind.h>

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "runtime/plan/run_plan.h"
#include "tests/scenes/hand_scenes.h"

namespace sinew::test {
namespace {

/// Adds unused parts: clips that never play, meshes without an instance, materials, lights, cameras, variants.
void add_unused(Scene& scene, std::uint32_t count) {
  const Scene face = face_scene();
  for (std::uint32_t i = 0; i < count; ++i) {
    scene.animations.push_back(scene.animations[0]);
    scene.meshes.push_back(face.meshes[0]);
    scene.materials.emplace_back();
    scene.lights.emplace_back();
    scene.cameras.emplace_back();
    scene.variants.emplace_back("variant");
  }
  finish_scene(scene);
}

/// Adds joints below the last joint, which the clip moves.
void add_joints(Scene& scene, std::uint32_t count) {
  Skeleton& skeleton = scene.skeleton;
  const auto first = static_cast<std::uint32_t>(skeleton.joint_count());
  for (std::uint32_t j = first; j < first + count; ++j) {
    skeleton.parents.push_back(first - 1);
    skeleton.rest.emplace_back();
    skeleton.fixed_matrix_of.push_back(kNone);
    skeleton.names.emplace_back("finger");
    skeleton.node_of_joint.push_back(j);
    skeleton.joint_of_node.push_back(j);
    BoneAnimation bone = scene.animations[0].bones[0];
    bone.joint = j;
    scene.animations[0].bones.push_back(std::move(bone));
  }
  if (count > 0) skeleton.level_begin.push_back(first + count);
}

/// Adds nodes beside the arm that no clip moves.
void add_static_nodes(Scene& scene, std::uint32_t count) {
  Skeleton& skeleton = scene.skeleton;
  const auto first = static_cast<std::uint32_t>(skeleton.joint_count());
  for (std::uint32_t j = first; j < first + count; ++j) {
    skeleton.parents.push_back(0);
    skeleton.rest.push_back({{0.5f, static_cast<float>(j), 0.25f}, glm::quat(1, 0, 0, 0), glm::vec3(1)});
    skeleton.fixed_matrix_of.push_back(kNone);
    skeleton.names.emplace_back("static");
    skeleton.node_of_joint.push_back(j);
    skeleton.joint_of_node.push_back(j);
  }
  skeleton.level_begin.back() += count;
}

Needs without_joints(std::uint32_t kept, std::uint32_t left_out) {
  Needs needs;
  needs.out.skeleton_lod.kept.assign(kept, true);
  needs.out.skeleton_lod.kept.resize(kept + left_out, false);
  return needs;
}

void play(const Plan& plan, FrameBuffer& frame, int first, int count) {
  for (int i = first; i < first + count; ++i) {
    const ClipLayer layer{0, 0.01 * i};
    if (run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, frame) != ErrorCode::ok) std::abort();
  }
}

}  // namespace
}  // namespace sinew::test

int main(int argc, char** argv) {
  using namespace sinew::test;
  std::uint32_t count = 0;
  if (argc != 2) return 2;
  const std::string_view text = argv[1];
  if (std::from_chars(text.data(), text.data() + text.size(), count).ec != std::errc()) return 2;
  sinew::Scene scene = arm_scene();
  add_static_nodes(scene, count);
  const auto joints = static_cast<std::uint32_t>(scene.skeleton.joint_count());
  add_joints(scene, count);
  scene.clips.clear();
  add_unused(scene, count);
  const sinew::Plan plan = sinew::compile_plan(lend(scene), without_joints(joints, count));
  sinew::FrameBuffer frame(plan);
  play(plan, frame, 0, 3);  // warms up: afterwards the kernels have chosen their instruction set
  CALLGRIND_START_INSTRUMENTATION;
  play(plan, frame, 3, 50);
  CALLGRIND_STOP_INSTRUMENTATION;
  const sinew::WorkCounters& work = frame.result().work;
  std::printf("%llu joints composed, %llu vertices skinned\n", static_cast<unsigned long long>(work.joints_composed),
              static_cast<unsigned long long>(work.vertices_skinned_linear));
  return work.vertices_skinned_linear == 4 ? 0 : 1;
}
