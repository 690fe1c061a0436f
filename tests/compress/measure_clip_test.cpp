// SPDX-License-Identifier: MIT
// Errors of clips that are wrong by a known amount.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "runtime/compress/clip_error.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

/// Bones of length 0.2 along y, and a clip of two seconds in which the second joint does not move.
Scene chain_scene(std::uint32_t joints) {
  Scene scene;
  scene.skeleton = test::chain_skeleton(joints);
  for (std::uint32_t j = 1; j < joints; ++j) scene.skeleton.rest[j].translation.y = 0.2f;
  BoneAnimation bone;
  bone.joint = 1;
  bone.translation = {Interpolation::linear, {0, 1, 2}, std::vector<glm::vec3>(3, {0, 0.2f, 0})};
  bone.rotation = {Interpolation::linear, {0, 1, 2}, std::vector<glm::quat>(3, quat_identity<float>())};
  scene.animations.push_back(test::animation_of({bone}));
  finish_scene(scene);
  return scene;
}

Clip clip_of(const Scene& scene, const Animation& animation) {
  return compile_clip(animation, scene.skeleton, rest_weights_of(scene), scene.first_weight, scene.properties);
}

ClipError measure(const Scene& scene, const std::vector<Animation>& forms, const std::vector<double>& times_s) {
  std::vector<Clip> clips;
  std::vector<const Clip*> pointers;
  clips.reserve(forms.size());
  for (const Animation& form : forms) {
    clips.push_back(clip_of(scene, form));
    pointers.push_back(&clips.back());
  }
  const VirtualVertices vertices = virtual_vertices(scene);
  return measure_clip(TruthSamples(scene, scene.animations[0], vertices, times_s), pointers);
}

TEST(measure_clip, a_shift_counts_from_its_joint_on_and_the_time_where_it_is_largest_is_named) {
  const Scene scene = chain_scene(4);
  Animation wrong = scene.animations[0];
  wrong.bones[0].translation.values[1] += glm::vec3(0.3f, 0.0f, -0.4f);
  const ClipError error = measure(scene, {wrong}, {0.0, 0.5, 1.0, 1.5, 2.0});
  EXPECT_EQ(error.of_joint_m[0], 0.0);
  for (std::size_t j = 1; j < 4; ++j) EXPECT_NEAR(error.of_joint_m[j], 0.5, 1e-6) << j;
  EXPECT_NEAR(error.worst_m, 0.5, 1e-6);
  EXPECT_EQ(error.worst_time_s, 1.0);
  EXPECT_NE(error.worst_joint, 0u);
  EXPECT_EQ(error.weights_m, 0.0);
}

TEST(measure_clip, a_turn_counts_by_the_farthest_corner_of_the_box) {
  const Scene scene = chain_scene(3);
  Animation wrong = scene.animations[0];
  const double angle = 0.1;
  const auto turned =
      quat_xyzw(0.0f, 0.0f, static_cast<float>(std::sin(angle / 2)), static_cast<float>(std::cos(angle / 2)));
  wrong.bones[0].rotation.values.assign(3, turned);
  const ClipError error = measure(scene, {wrong}, {1.0});
  const auto moved_by = [&](double x, double y) { return 2.0 * std::sin(angle / 2) * std::hypot(x, y); };
  EXPECT_NEAR(error.of_joint_m[1], moved_by(0.03, 0.03), 1e-6);
  EXPECT_NEAR(error.of_joint_m[2], moved_by(0.03, 0.23), 1e-6);
  EXPECT_EQ(error.worst_joint, 2u);
  EXPECT_NEAR(error.worst_m, moved_by(0.03, 0.23), 1e-6);
}

TEST(measure_clip, of_several_forms_and_times_each_error_is_the_largest) {
  const Scene scene = chain_scene(2);
  Animation early = scene.animations[0], late = scene.animations[0];
  early.bones[0].translation.values[0].x = 0.25f;
  late.bones[0].translation.values[2].x = 0.125f;
  for (const bool turned : {false, true}) {
    const ClipError error =
        turned ? measure(scene, {late, early}, {0.0, 2.0}) : measure(scene, {early, late}, {2.0, 0.0});
    EXPECT_NEAR(error.of_joint_m[1], 0.25, 1e-6);
    EXPECT_EQ(error.worst_time_s, 0.0);
  }
}

TEST(measure_clip, a_clip_that_is_right_has_no_worst_joint) {
  const Scene scene = chain_scene(3);
  const ClipError error = measure(scene, {scene.animations[0]}, {0.0, 0.7, 2.0});
  EXPECT_EQ(error.worst_m, 0.0);
  EXPECT_EQ(error.worst_joint, kNone);
}

/// Two instances of a mesh with two targets that displace 2 m and 1 m per unit of weight; rest weights are 0.
Scene morphed_scene() {
  Scene scene = chain_scene(3);
  Mesh& mesh = scene.meshes.emplace_back();
  mesh.primitives.resize(1);
  mesh.primitives[0].positions.assign(4, glm::vec3(0));
  mesh.default_weights.assign(2, 0.0f);
  mesh.primitives[0].morphs.targets.resize(2);
  mesh.primitives[0].morphs.targets[0].positions = {{1, 3}, {{0, 2, 0}, {1, 0, 0}}};
  mesh.primitives[0].morphs.targets[1].positions = {{2}, {{0, 0, -1}}};
  for (int i = 0; i < 2; ++i) scene.instances.push_back({.joint = 0, .mesh = 0, .rest_weights = {0, 0}});
  WeightAnimation animated;
  animated.instance = 1;
  animated.weights = {Interpolation::linear, {0, 2}, {0.5f, 0.25f, 0.5f, 0.25f}, 2};
  scene.animations[0].weights.push_back(animated);
  scene.clips.clear();
  finish_scene(scene);
  return scene;
}

/// The truth with both weights wrong, by -1/8 and +1/4: each displaces 1/4 m.
Animation with_wrong_weights(const Scene& scene) {
  Animation wrong = scene.animations[0];
  wrong.weights[0].weights.values = {0.375f, 0.5f, 0.375f, 0.5f};
  return wrong;
}

TEST(measure_clip, weights_count_by_the_sum_of_what_they_displace) {
  const Scene scene = morphed_scene();
  const ClipError error = measure(scene, {with_wrong_weights(scene)}, {0.0, 1.0});
  EXPECT_NEAR(error.weights_m, 0.5, 1e-6);
  EXPECT_NEAR(error.worst_m, 0.5, 1e-6);
  EXPECT_EQ(error.worst_joint, kNone);
}

TEST(measure_clip, errors_of_weights_and_joints_at_one_time_add_up) {
  const Scene scene = morphed_scene();
  Animation wrong = with_wrong_weights(scene);
  wrong.bones[0].translation.values[2].z = 0.125f;
  const ClipError error = measure(scene, {wrong}, {0.0, 2.0});
  EXPECT_NEAR(error.weights_m, 0.5, 1e-6);
  EXPECT_NEAR(error.worst_m, 0.625, 1e-6);
  EXPECT_EQ(error.worst_time_s, 2.0);
  EXPECT_EQ(error.worst_joint, 1u);
}

TEST(measure_clip, weights_without_keys_are_at_rest_and_right) {
  Scene scene = morphed_scene();
  WeightTrack& weights = scene.animations[0].weights[0].weights;
  weights.times_s.clear();
  weights.values.clear();
  scene.clips.clear();
  finish_scene(scene);
  EXPECT_EQ(measure(scene, {scene.animations[0]}, {0.0, 1.0}).weights_m, 0.0);
}

TEST(measure_clip, displacements_are_stretched_by_the_joint_and_the_largest_copy) {
  Scene scene = morphed_scene();
  scene.skeleton.rest[2].scale = {3, 3, 3};
  scene.instances[1].joint = 2;
  EXPECT_NEAR(measure(scene, {with_wrong_weights(scene)}, {1.0}).weights_m, 1.5, 1e-6);
  const Transform small{{5, 0, 0}, quat_identity<float>(), {0.5f, 0.5f, 0.5f}};
  const Transform large{{0, 0, 0}, quat_identity<float>(), {2, 2, 2}};
  scene.instances[1].copies = {small};
  EXPECT_NEAR(measure(scene, {with_wrong_weights(scene)}, {1.0}).weights_m, 0.75, 1e-6);
  for (const bool first : {true, false}) {
    scene.instances[1].copies = first ? std::vector{large, small} : std::vector{small, large};
    EXPECT_NEAR(measure(scene, {with_wrong_weights(scene)}, {1.0}).weights_m, 3.0, 1e-6);
  }
}

TEST(measure_clip, displacements_of_a_skin_are_stretched_by_its_widest_joint) {
  for (const bool first : {true, false}) {
    Scene scene = morphed_scene();
    scene.skeleton.rest[first ? 1 : 2].scale = {2, 2, 2};
    Skin& skin = scene.skins.emplace_back();
    skin.joints = first ? std::vector<std::uint32_t>{1, 0} : std::vector<std::uint32_t>{0, 2};
    skin.inverse_bind.assign(2, affine_from_transform(Transform{{1, 2, 3}, quat_identity<float>(), {3, 3, 3}}));
    scene.instances[1].skin = 0;
    EXPECT_NEAR(measure(scene, {with_wrong_weights(scene)}, {1.0}).weights_m, 0.5 * 2 * 3, 1e-5);
  }
}

TEST(measure_clip, of_several_instances_the_one_that_is_farthest_off_counts) {
  for (const std::uint32_t larger : {0u, 1u}) {
    Scene scene = morphed_scene();
    WeightAnimation other = scene.animations[0].weights[0];
    other.instance = 0;
    scene.animations[0].weights.push_back(other);
    scene.clips.clear();
    finish_scene(scene);
    Animation wrong = scene.animations[0];
    for (WeightAnimation& animated : wrong.weights)
      animated.weights.values[0] += animated.instance == larger ? 0.25f : 0.0625f;
    EXPECT_NEAR(measure(scene, {wrong}, {0.0}).weights_m, 0.5, 1e-6);
  }
}

TEST(measure_clip, times_between_keys_are_sixths_of_their_distance) {
  BoneAnimation bone;
  bone.translation = {Interpolation::linear, {0.0f, 0.5f, 2.0f}, std::vector<glm::vec3>(3)};
  const std::vector<double> times = times_to_check(test::animation_of({bone}), 1);
  ASSERT_EQ(times.size(), 13u);
  for (std::size_t i = 0; i < times.size(); ++i)
    EXPECT_NEAR(times[i], i <= 6 ? static_cast<double>(i) / 12 : 0.5 + static_cast<double>(i - 6) * 0.25, 1e-12) << i;
}

TEST(measure_clip, times_of_weights_and_both_ends_are_looked_at) {
  Animation animation;
  animation.duration_s = 4.0;
  WeightAnimation animated;
  animated.weights = {Interpolation::step, {1.0f, 2.0f}, {0.0f, 1.0f}, 1};
  animation.weights.push_back(animated);
  EXPECT_EQ(key_times(animation), (std::vector<float>{0.0f, 1.0f, 2.0f, 4.0f}));
  const std::vector<double> times = times_to_check(animation, 0);
  EXPECT_EQ(times.front(), 0.0);
  EXPECT_EQ(times.back(), 4.0);
  EXPECT_EQ(std::count(times.begin(), times.end(), static_cast<double>(std::nextafter(2.0f, 0.0f))), 1);
  EXPECT_EQ(times.size(), 4 + 15 + 1u) << "the first key of steps is no jump";
}

}  // namespace
}  // namespace sinew
