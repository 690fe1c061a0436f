// SPDX-License-Identifier: MIT
// Prints the bits of poses and vertices of a scene that the library alone computes. This file supplies the numbers, and
// uses no function that engine.cpp uses, too.
#include <cinttypes>
#include <cstdio>
#include <vector>

#include "runtime/animation/truth_pose.h"
#include "runtime/math/decompose.h"
#include "runtime/math/euler.h"
#include "runtime/plan/frame_hash.h"
#include "runtime/plan/run_plan.h"
#include "runtime/playback/root_motion.h"

namespace sinew::test {
double use_inline_functions(const QuatTrack& rotations, const Vec3Track& vectors, const WeightTrack& weights,
                            double time_s) noexcept;
}

namespace {
using namespace sinew;

constexpr std::uint32_t kJoints = 6, kKeys = 5, kVertices = 96;

/// Numbers between -1 and 1, the same everywhere.
class Numbers {
 public:
  float next() noexcept {
    state_ = state_ * 1664525u + 1013904223u;
    return static_cast<float>(static_cast<std::int32_t>(state_ >> 8) - (1 << 23)) * 0x1p-23f;
  }

 private:
  std::uint32_t state_ = 7;
};

/// A quarter of the rows of kTurns is a unit quaternion, exactly: no square root is needed.
constexpr float kTurns[4][4] = {
    {0.5f, 0.5f, 0.5f, 0.5f}, {0.6f, 0.0f, 0.8f, 0.0f}, {0.28f, 0.96f, 0.0f, 0.0f}, {0.0f, 0.6f, 0.0f, -0.8f}};

BoneAnimation bone(std::uint32_t joint, Interpolation interpolation, Numbers& numbers) {
  BoneAnimation bone;
  bone.joint = joint;
  bone.rotation.interpolation = interpolation;
  bone.scale.interpolation = bone.translation.interpolation = Interpolation::linear;
  const std::uint32_t rows = interpolation == Interpolation::cubic_spline ? 3 : 1;
  for (std::uint32_t key = 0; key < kKeys; ++key) {
    bone.rotation.times_s.push_back(0.3f * static_cast<float>(key));
    for (std::uint32_t row = 0; row < rows; ++row) {
      const float* turn = kTurns[(joint + key) % 4];
      bone.rotation.values.push_back(glm::quat(turn[0], turn[1], turn[2], turn[3]));
    }
    bone.translation.values.push_back({numbers.next(), numbers.next(), numbers.next()});
    bone.scale.values.push_back({1.5f + numbers.next() / 4, 1.0f, 0.75f});
  }
  bone.translation.times_s = bone.scale.times_s = bone.rotation.times_s;
  return bone;
}

Primitive tube(Numbers& numbers) {
  Primitive tube;
  for (std::uint32_t v = 0; v < kVertices; ++v) {
    tube.positions.push_back({numbers.next(), numbers.next(), numbers.next()});
    tube.normals.push_back({0.6f, 0.0f, v % 2 == 0 ? 0.8f : -0.8f});
    tube.indices.push_back(v);
    for (std::uint32_t i = 0; i < 3; ++i) {
      tube.influences.joints.push_back(static_cast<std::uint16_t>((v + i) % kJoints));
      tube.influences.weights.push_back(i == 0 ? 0.5f : 0.25f);
    }
  }
  tube.influences.groups = {{0, kVertices, 3, 0}};
  tube.bounds = {{-1, -1, -1}, {1, 1, 1}};
  return tube;
}

Scene made_scene() {
  Numbers numbers;
  Scene scene;
  Animation animation{"all", 1.2, {}, {}};
  constexpr Interpolation kKinds[] = {Interpolation::linear, Interpolation::squad, Interpolation::cubic_spline};
  for (std::uint32_t joint = 0; joint < kJoints; ++joint) {
    scene.skeleton.parents.push_back(joint == 0 ? kNone : joint - 1);
    scene.skeleton.rest.push_back({{0.1f, 1.0f, 0.3f}, glm::quat(1, 0, 0, 0), {1, 1, 1}});
    scene.skeleton.fixed_matrix_of.push_back(kNone);
    scene.skeleton.names.emplace_back("joint");
    scene.skeleton.node_of_joint.push_back(joint);
    scene.skeleton.joint_of_node.push_back(joint);
    scene.skeleton.level_begin.push_back(joint);
    animation.bones.push_back(bone(joint, kKinds[joint % 3], numbers));
  }
  scene.skeleton.level_begin.push_back(kJoints);
  scene.animations.push_back(std::move(animation));
  scene.skins.push_back({"skin", {0, 1, 2, 3, 4, 5}, std::vector<Affine>(kJoints), kNone});
  scene.meshes.push_back({"tube", {tube(numbers)}, {}, {}});
  scene.instances.push_back({.joint = 0, .mesh = 0, .skin = 0, .rest_weights = {}});
  finish_scene(scene);
  return scene;
}

bool print_frames(const Scene& scene, Skinning skinning) {
  Needs needs;
  needs.skin.kind = skinning;
  const Plan plan = compile_plan(lend(scene), needs);
  FrameBuffer frame(plan);
  for (int step = 0; step < 9; ++step) {
    const ClipLayer layers[] = {{.clip = 0, .time_s = 0.137 * step, .weight = 0.75f},
                                {.clip = 0, .time_s = 1.2 - 0.137 * step, .weight = 0.5f}};
    if (run_plan(plan, {.layers = layers, .weights = {}, .root = {}}, frame) != ErrorCode::ok) return false;
    std::printf("%d %016" PRIx64 " %016" PRIx64 "\n", step, hash_pose(frame.result()), hash_vertices(frame.result()));
  }
  return true;
}

/// Poses in double precision, and what decomposition, Euler angles and root motion make of them.
void print_truth(const Scene& scene) {
  TruthPose pose;
  BitHash hash;
  for (int step = 0; step < 9; ++step) {
    evaluate_truth(scene.animations[0], scene.skeleton, 0.137 * step, pose);
    hash.add(std::span<const Affined>(pose.model));
    for (const Affined& model : pose.model) {
      const auto parts = decompose_trs(model);
      const auto angles = euler_from_matrix(EulerOrder{}, decompose_polar(Mat3<double>(0.3)).rotation);
      const auto turned = quat_from_head_pitch_roll(HeadPitchRollT<double>{parts.transform.scale.x, angles.y, 0.25});
      hash.add(std::span(&parts.transform, 1)).add(std::span(&angles, 1)).add(std::span(&turned, 1));
    }
    for (const BoneAnimation& bone : scene.animations[0].bones) {
      const auto at = bone.interpolate<float>(0.137 * step);
      const auto place = root_place(bone, scene.skeleton.rest[0], {}, 0.137 * step);
      hash.add(std::span(&at, 1)).add(std::span(&place, 1));
    }
  }
  std::printf("truth %016" PRIx64 "\n", hash.value());
}

}  // namespace

int main() {
  const Scene scene = made_scene();
  if (check(scene) != ErrorCode::ok) return 1;
  const auto& bone = scene.animations[0].bones[0];
  const WeightTrack weights{Interpolation::linear, {0, 1}, {0, 1}, 1};
  if (test::use_inline_functions(bone.rotation, bone.translation, weights, 0.5) == 0.0) return 1;
  print_truth(scene);
  for (const Skinning skinning : {Skinning::linear, Skinning::dual_quaternion})
    if (!print_frames(scene, skinning)) return 1;
  return 0;
}
