// SPDX-License-Identifier: MIT
#include "runtime/compress/truth_samples.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/compress/clip_error.h"
#include "runtime/compress/compile_clip_within.h"
#include "tests/scenes/skeletons.h"
#include "tests/scenes/swinging.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

/// A swinging chain. Its tip has a mesh with two animated morph targets.
Scene swinging_scene(std::size_t keys) {
  Scene scene;
  scene.skeleton = scenes::long_chain(6);
  scene.animations.push_back(scenes::swinging(scene.skeleton, keys));
  Mesh& mesh = scene.meshes.emplace_back();
  mesh.primitives.resize(1);
  mesh.primitives[0].positions = {{0, 0, 0}, {0.1f, 0, 0}, {0, 0.2f, 0}};
  mesh.default_weights.assign(2, 0.0f);
  mesh.primitives[0].morphs.targets.resize(2);
  mesh.primitives[0].morphs.targets[0].positions = {{1}, {{0, 0.3f, 0}}};
  mesh.primitives[0].morphs.targets[1].positions = {{2}, {{0.5f, 0, 0}}};
  for (const std::uint32_t joint : {2u, 5u})
    scene.instances.push_back({.joint = joint, .mesh = 0, .rest_weights = {0, 0}});
  WeightAnimation animated;
  animated.instance = 1;
  animated.weights = {Interpolation::linear, scene.animations[0].bones[0].rotation.times_s, {}, 2};
  for (const float t : animated.weights.times_s) {
    animated.weights.values.push_back(std::sin(t));
    animated.weights.values.push_back(0.5f * std::cos(3.0f * t));
  }
  scene.animations[0].weights.push_back(animated);
  finish_scene(scene);
  return scene;
}

std::size_t bytes_of_sample(const Scene& scene) {
  return sizeof(TruthSample) + scene.skeleton.joint_count() * sizeof(BoxCorners) + 4 * sizeof(double);
}

TEST(truth_samples, corners_have_the_bits_of_transformed_points) {
  test::FixedRandom random(4);
  for (int round = 0; round < 100; ++round) {
    Affined model;
    for (Vec4<double>& row : model.row) row = {random.in(-3, 3), random.in(-3, 3), random.in(-3, 3), random.in(-3, 3)};
    Aabb box;
    box.add(random.vec3(-1, 1));
    box.add(random.vec3(-1, 1));
    const BoxCorners corners = corners_in_model(model, box);
    const auto points = corners_of(box);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3<double> expected = transform_point(model, points[i]);
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_EQ(corners[static_cast<std::size_t>(axis)][i], expected[axis]) << i << " " << axis;
    }
  }
}

TEST(truth_samples, what_is_measured_does_not_depend_on_how_many_are_kept) {
  const Scene scene = swinging_scene(20);
  Animation wrong = scene.animations[0];
  for (BoneAnimation& bone : wrong.bones) bone.rotation.values[11] = bone.rotation.values[10];
  wrong.weights[0].weights.values[9] += 0.25f;
  const Clip clip = compile_clip(wrong, scene.skeleton, rest_weights_of(scene), scene.first_weight, scene.properties);
  const Clip* const forms[] = {&clip};
  const VirtualVertices vertices = virtual_vertices(scene);
  const std::vector<double> times_s = times_to_check(scene.animations[0], scene.skeleton.joint_count());
  const auto measured = [&](std::size_t kept_bytes, std::size_t expected_kept) {
    const TruthSamples truth(scene, scene.animations[0], vertices, times_s, kept_bytes);
    EXPECT_EQ(truth.kept_count(), expected_kept);
    return measure_clip(truth, forms);
  };
  const std::size_t all = times_s.size(), some = all / 3;
  const ClipError kept = measured(TruthSamples::kMaxKeptBytes, all);
  EXPECT_GT(kept.worst_m, 1e-3);
  EXPECT_GT(kept.weights_m, 1e-3);
  EXPECT_EQ(kept.truth_poses, 0u);
  for (const std::size_t count : {std::size_t{0}, some, all}) {
    const ClipError error = measured(count * bytes_of_sample(scene), count);
    EXPECT_EQ(error.of_joint_m, kept.of_joint_m);
    EXPECT_EQ(error.weights_m, kept.weights_m);
    EXPECT_EQ(error.worst_m, kept.worst_m);
    EXPECT_EQ(error.worst_time_s, kept.worst_time_s);
    EXPECT_EQ(error.worst_joint, kept.worst_joint);
    EXPECT_EQ(error.truth_poses, all - count);
  }
}

TEST(truth_samples, a_search_evaluates_each_pose_of_the_truth_once) {
  const Scene scene = swinging_scene(60);
  const ClipWithin within = compile_clip_within(scene, scene.animations[0], virtual_vertices(scene), 1e-3);
  EXPECT_GT(within.clip.certificate()->times_checked, 300u);
  EXPECT_EQ(within.truth_poses, within.clip.certificate()->times_checked);
}

}  // namespace
}  // namespace sinew
