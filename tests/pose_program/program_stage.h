// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <span>
#include <vector>

#include "runtime/pose/pose_memory.h"
#include "runtime/pose_program/run_pose_program.h"
#include "tests/reference/pose_program.h"
#include "tests/scenes/random_inputs.h"
#include "tests/scenes/random_scene.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {

/// A random scene. Each of its clips also animates two properties of a material.
inline Scene scene_with_properties(std::uint64_t seed) {
  Scene scene = random_scene(seed);
  scene.materials.resize(1);
  for (std::size_t c = 0; c < scene.animations.size(); ++c) {
    const float most = 0.25f * static_cast<float>(c + 1);
    scene.animations[c].properties = {
        {{PropertyKind::roughness, 0}, {Interpolation::linear, {0.0f, 1.0f}, {most, 0.0f}, 1}},
        {{PropertyKind::emissive, 0}, {Interpolation::linear, {0.0f, 1.0f}, {0.0f, most, 1.0f, most, 1.0f, 2.0f}, 3}}};
  }
  scene.clips.clear();
  finish_scene(scene);
  return scene;
}

/// A scene with what programs read of it, and memory to run them in.
struct ProgramStage {
  Scene scene;
  std::vector<float> rest_weights;
  PoseMemory rest, result, external_memory;
  std::vector<std::vector<float>> mask_memory;
  std::vector<std::span<const float>> masks;
  PoseProgramAssets assets;
  ExternalPose external;
  std::vector<float> external_weights, weights, properties;
  std::vector<float> mask_of_weights, mask_of_properties;
  PoseMask mask;  ///< of the caller, with index 2
  MirrorMap map;
  Affine root;
  MirrorTables mirror;
  std::vector<std::vector<JointOverride>> override_memory;
  std::vector<JointOverrides> overrides;
  std::vector<PoseProcedure> procedures;
  std::unique_ptr<std::byte[], decltype(&std::free)> block{nullptr, std::free};
  std::size_t bytes = 0;
  PoseProgramWork work;

  explicit ProgramStage(std::uint64_t seed)
      : scene(scene_with_properties(seed)),
        rest_weights(rest_weights_of(scene)),
        rest(joints()),
        result(joints()),
        external_memory(joints()) {
    FixedRandom random(seed);
    mask_memory.resize(2);
    for (std::size_t j = 0; j < joints(); ++j) {
      rest.span().set(j, scene.skeleton.rest[j]);
      Transform moved = scene.skeleton.rest[j];
      moved.translation += random.vec3(-0.2, 0.2);
      moved.rotation = random.rotation_by(0.4) * moved.rotation;
      external_memory.span().set(j, moved);
      mask_memory[0].push_back(static_cast<float>(random.unit()));
      mask_memory[1].push_back(random.below(2) == 0 ? 0.0f : 1.0f);
    }
    masks.assign(mask_memory.begin(), mask_memory.end());
    for (std::size_t i = 0; i < rest_weights.size(); ++i) external_weights.push_back(static_cast<float>(random.unit()));
    for (std::size_t i = 0; i < rest_weights.size(); ++i) mask_of_weights.push_back(static_cast<float>(random.unit()));
    for (std::size_t i = 0; i < scene.properties.rest.size(); ++i)
      mask_of_properties.push_back(random.below(2) == 0 ? 0.0f : 1.5f);
    mask = {mask_memory[0], mask_of_weights, mask_of_properties, 1};
    external = {external_memory.span(), external_weights, {}, 0};
    root = affine_cast<float>(affine_from_transform(
        Transformd{Vec3<double>(3, -1, 2), quat_cast<double>(random.rotation_by(0.5)), Vec3<double>(1.5)}));
    override_memory.resize(3);
    for (const OverrideSpace space : {OverrideSpace::local, OverrideSpace::model, OverrideSpace::world})
      for (int i = 0; i < 2; ++i)
        override_memory[static_cast<std::size_t>(space)].push_back(
            {random.below(static_cast<std::uint32_t>(joints())),
             {random.vec3(-1, 1), random.rotation_by(0.3), {1, 1, 1}},
             space});
    for (const std::vector<JointOverride>& joints_of : override_memory) overrides.push_back({joints_of, 0});
    assets = {.skeleton = &scene.skeleton,
              .clips = scene.clips,
              .rest = rest.span(),
              .rest_weights = rest_weights,
              .rest_properties = scene.properties.rest,
              .masks = masks};
    procedures = {{&bend, nullptr, 1}};
    weights.resize(rest_weights.size());
    properties.resize(scene.properties.rest.size());
    bytes = pose_program_bytes(assets,
                               {.slots = 12, .overlays_in_model_space = true, .kept = 8});  // with room for a mirror
    block.reset(static_cast<std::byte*>(std::aligned_alloc(64, bytes)));
  }

  std::size_t joints() const { return scene.skeleton.joint_count(); }

  PoseProgramJob job(PoseProgramSpan program) {
    return {
        .program = program,
        .assets = &assets,
        .inputs = {.externals = {&external, 1}, .overrides = overrides, .procedures = procedures, .masks = {&mask, 1}},
        .memory = {block.get(), bytes},
        .pose = result.span(),
        .weights = weights,
        .properties = properties,
        .work = &work,
        .root = root};
  }
  ErrorCode run_program(const PoseProgram& program) { return run(job(program.ops())); }

  reference::SlowPose run_slowly(PoseProgramSpan program) const {
    reference::SlowPose slow_external;
    for (std::size_t j = 0; j < joints(); ++j) slow_external.joints.push_back(in_double(external.pose.get(j)));
    slow_external.weights.assign(external_weights.begin(), external_weights.end());
    slow_external.properties.assign(scene.properties.rest.begin(), scene.properties.rest.end());
    reference::SlowTables tables{.externals = {slow_external}, .overrides = overrides, .mirror = &map, .root = root};
    for (const std::span<const float> joints_of : masks) tables.masks.push_back({.joints = joints_of});
    tables.masks.push_back(mask);
    tables.procedures.push_back([](reference::SlowPose& pose, double share) {
      for (Transformd& joint : pose.joints) joint.translation.y += 0.1 * share;
      for (double& weight : pose.weights) weight *= 1.0 - 0.5 * share;
    });
    return reference::SlowProgram(scene, rest_weights, std::move(tables)).run(program);
  }

  /// Lets programs mirror.
  void use_mirror() {
    map = some_mirror(scene);
    mirror = make_mirror_tables(map.joints);
    assets.mirror = &mirror;
    assets.mirrored_weight_source = map.weight_source;
  }

 private:
  /// Raises all joints and shrinks the morph weights.
  static void bend(void*, const ProcedurePose& pose) {
    for (std::size_t j = 0; j < pose.local.joint_count; ++j) {
      Transform joint = pose.local.get(j);
      joint.translation.y += 0.1f * pose.share;
      pose.local.set(j, joint);
    }
    for (float& weight : pose.weights) weight *= 1.0f - 0.5f * pose.share;
  }
};

}  // namespace sinew::test
