// SPDX-License-Identifier: MIT
// Checks the promise of compile_skeleton_lod by comparing frames with all joints and frames without the left-out ones.
#include "runtime/lod/compile_skeleton_lod.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "runtime/animation/truth_pose.h"
#include "runtime/compress/clip_error.h"
#include "runtime/compress/virtual_vertices.h"
#include "runtime/plan/plan_assets.h"
#include "tests/plan/frame_difference.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/scenes/random_scene.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {
namespace {

RandomSceneOptions without_morphs() {
  RandomSceneOptions options;
  options.targets = 0;
  options.joints = 24;
  return options;
}

TEST(compile_skeleton_lod, no_vertex_is_farther_off_than_asked) {
  std::size_t left_out = 0;
  for (std::uint32_t seed = 3; seed < 9; ++seed) {
    const Scene scene = random_scene(seed, without_morphs());
    std::uint32_t last = 0;
    for (const double tolerance_m : {0.0, 3.0, 5.0, 8.0, 1e3}) {
      const CompiledSkeletonLod within = compile_skeleton_lod(scene, tolerance_m);
      EXPECT_LE(within.measured_m, tolerance_m);
      EXPECT_GE(within.left_out, last) << "more tolerance never leaves out less";
      last = within.left_out;
      for (const std::uint32_t clip : {0u, 1u}) {
        const Difference off = difference_of(scene, within.detail, clip, 90);
        EXPECT_LE(off.worst_m, tolerance_m * 1.02 + 3e-6 * off.far_m)
            << "seed " << seed;  // cubics between the tested times
      }
    }
    EXPECT_EQ(last, scene.skeleton.joint_count() - 1) << "all but the root";
    left_out += compile_skeleton_lod(scene, 5.0).left_out - compile_skeleton_lod(scene, 0.0).left_out;
  }
  EXPECT_GT(left_out, 30u) << "joints that move and matter little";
}

/// How far vertices of a joint and its descendants move if that joint is left out too, over all tested times.
double cost_of_leaving_out(const Scene& scene, const SkeletonLod& detail, std::uint32_t joint,
                           std::span<const std::uint32_t> clips) {
  const VirtualVertices vertices = virtual_vertices(scene);
  const Skeleton& skeleton = scene.skeleton;
  double worst_m = 0.0;
  for (const std::uint32_t clip : clips)
    for (const double time_s : times_to_check(scene.animations[clip], skeleton.joint_count())) {
      TruthPose pose;
      evaluate_truth(scene.animations[clip], skeleton, time_s, pose);
      std::vector<bool> gone(skeleton.joint_count(), false);
      std::vector<Affined> held = pose.model;
      for (std::uint32_t j = joint; j < skeleton.joint_count(); ++j) {
        gone[j] = j == joint || (skeleton.parents[j] != kNone && gone[skeleton.parents[j]]);
        if (!gone[j]) continue;
        const std::uint32_t fixed = skeleton.fixed_matrix_of[j];
        held[j] = held[skeleton.parents[j]] * (fixed == kNone ? affine_from_transform(in_double(detail.held[j]))
                                                              : affine_cast<double>(skeleton.fixed_matrices[fixed]));
        if (!vertices.moves_vertices[j]) continue;
        for (const Vec3<double>& corner : corners_of(vertices.boxes[j]))
          worst_m =
              std::max(worst_m, glm::length(transform_point(held[j], corner) - transform_point(pose.model[j], corner)));
      }
    }
  return worst_m;
}

TEST(compile_skeleton_lod, not_one_more_joint_could_go) {
  const std::uint32_t clips[] = {0, 1};
  std::size_t looked_at = 0;
  for (std::uint32_t seed = 1; seed < 5; ++seed) {
    const Scene scene = random_scene(seed, without_morphs());
    for (const double tolerance_m : {3.0, 6.0}) {
      const CompiledSkeletonLod within = compile_skeleton_lod(scene, tolerance_m);
      if (within.left_out == 0) continue;
      for (std::uint32_t j = 0; j < scene.skeleton.joint_count(); ++j) {
        if (scene.skeleton.parents[j] == kNone || !within.detail.kept[j]) continue;
        ++looked_at;
        EXPECT_GT(cost_of_leaving_out(scene, within.detail, j, clips), tolerance_m * 0.999)
            << "seed " << seed << " joint " << j;
      }
    }
  }
  EXPECT_GT(looked_at, 30u);
}

TEST(compile_skeleton_lod, what_it_says_was_measured_is_what_another_look_finds_too) {
  const std::uint32_t clips[] = {0, 1};
  int measured = 0;
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const Scene scene = random_scene(seed, without_morphs());
    const CompiledSkeletonLod within = compile_skeleton_lod(scene, 5.0);
    if (within.worst_joint == kNone) continue;
    ++measured;
    const std::uint32_t above = map_joints(scene, within.detail)[within.worst_joint].kept_joint;
    std::uint32_t top = within.worst_joint;  // the uppermost joint of the left-out branch
    while (scene.skeleton.parents[top] != above) top = scene.skeleton.parents[top];
    EXPECT_NEAR(cost_of_leaving_out(scene, within.detail, top, clips), within.measured_m, 1e-4);
  }
  EXPECT_GT(measured, 2);
}

/// The arm with one clip that rotates only the lower joint, with one of the keys at each second.
Scene clenched_scene(const std::vector<glm::quat>& keys) {
  Scene scene = arm_scene();
  std::vector<float> times;
  for (std::size_t k = 0; k < keys.size(); ++k) times.push_back(static_cast<float>(k));
  scene.animations[0].bones = {BoneAnimation{}};
  scene.animations[0].bones[0].joint = 2;
  scene.animations[0].bones[0].rotation = {Interpolation::linear, times, keys};
  scene.animations[0].duration_s = static_cast<double>(times.back());
  scene.clips.clear();
  finish_scene(scene);
  return scene;
}

TEST(compile_skeleton_lod, a_joint_that_all_clips_hold_in_one_pose_goes_for_nothing_whatever_it_rests_at) {
  const glm::quat bent = normalised(quat_xyzw(0.0f, 0.0f, 0.6f, 0.8f));
  const Scene held = clenched_scene({bent, bent, bent});
  const CompiledSkeletonLod within = compile_skeleton_lod(held, 0.0);
  EXPECT_EQ(within.detail.kept, (std::vector<bool>{true, true, false}));
  EXPECT_EQ(within.measured_m, 0.0);
  EXPECT_LE(difference_of(held, within.detail, 0, 20).worst_m, 1e-6);
  EXPECT_TRUE(compile_skeleton_lod(held, 0.0, std::vector<std::uint32_t>{0, kNone}).detail.kept.empty())
      << "but not where the rest pose shows too";
  const Scene moving = clenched_scene({bent, bent, quat_identity<float>()});
  EXPECT_TRUE(compile_skeleton_lod(moving, 0.0).detail.kept.empty());
}

TEST(compile_skeleton_lod, N17_the_held_pose_is_the_mean_for_any_quaternion_sign) {
  const glm::quat a = normalised(quat_xyzw(0.0f, 0.0f, 0.1f, 1.0f)), b = normalised(quat_xyzw(0.0f, 0.0f, -0.1f, 1.0f));
  const CompiledSkeletonLod within = compile_skeleton_lod(clenched_scene({a, -b, a, -b, a, -b}), 1e3);
  ASSERT_EQ(within.left_out, 1u);
  EXPECT_NEAR(within.detail.held[2].rotation.z, 0.0f, 0.02f);
  EXPECT_NEAR(std::abs(within.detail.held[2].rotation.w), 1.0f, 1e-3f);
}

TEST(compile_skeleton_lod, each_part_of_the_pose_held_is_the_mean_of_what_clips_do) {
  Scene scene = clenched_scene({quat_identity<float>(), quat_identity<float>()});
  BoneAnimation& bone = scene.animations[0].bones[0];
  bone.translation = {Interpolation::linear, {0, 1}, {{0, 1, 0}, {0.5f, 2, 0}}};
  bone.scale = {Interpolation::linear, {0, 1}, {{1, 1, 1}, {3, 2, 1}}};
  scene.clips.clear();
  finish_scene(scene);
  const CompiledSkeletonLod within = compile_skeleton_lod(scene, 1e3);
  ASSERT_EQ(within.left_out, 1u);
  EXPECT_LT(glm::distance(within.detail.held[2].translation, glm::vec3(0.25f, 1.5f, 0)), 1e-6f);
  EXPECT_LT(glm::distance(within.detail.held[2].scale, glm::vec3(2, 1.5f, 1)), 1e-6f);
}

TEST(compile_skeleton_lod, joints_that_carry_nothing_go_and_those_of_cameras_lights_and_correctives_stay) {
  Scene scene = random_scene(1, without_morphs());
  scene.instances.clear();
  scene.clips.clear();
  scene.instances.push_back({.joint = 0, .mesh = 0, .skin = kNone, .rest_weights = {}});
  finish_scene(scene);
  EXPECT_EQ(compile_skeleton_lod(scene, 0.0).left_out, scene.skeleton.joint_count() - 1);
  scene.cameras.push_back({.name = "eye", .joint = 9});
  scene.lights.push_back({.name = "lamp", .joint = 17});
  const CompiledSkeletonLod within = compile_skeleton_lod(scene, 0.0);
  for (const std::uint32_t needed : {9u, 17u})
    for (std::uint32_t j = needed; j != kNone; j = scene.skeleton.parents[j]) EXPECT_TRUE(within.detail.kept[j]) << j;
  EXPECT_GT(within.left_out, 5u);
  RandomSceneOptions options;
  options.correctives = 2;
  const Scene corrected = random_scene(1, options);
  const CompiledSkeletonLod of_corrected = compile_skeleton_lod(corrected, 1e6);
  for (const PoseCorrective& corrective : corrected.correctives)
    for (const PoseDriver& driver : corrective.samples.drivers) EXPECT_TRUE(of_corrected.detail.kept[driver.joint]);
}

TEST(compile_skeleton_lod, other_kinds_of_skinning_are_within_the_tolerance_too) {
  std::size_t left_out = 0;
  for (const std::uint32_t seed : {4u, 5u}) {
    RandomSceneOptions options = without_morphs();
    options.centers = true;
    options.mirrored_joints = seed == 5;
    options.triangles = 12;
    const Scene scene = random_scene(seed, options);
    const CompiledSkeletonLod linear = compile_skeleton_lod(scene, 8.0);
    for (const Skinning skinning : {Skinning::dual_quaternion, Skinning::center_of_rotation}) {
      Needs needs;
      needs.skin.kind = skinning;
      const CompiledSkeletonLod within = compile_skeleton_lod(scene, 8.0, {}, needs);
      EXPECT_LE(within.left_out, linear.left_out);
      EXPECT_LE(within.measured_m, 8.0);
      left_out += within.left_out;
      for (const std::uint32_t clip : {0u, 1u})
        EXPECT_LE(difference_of(scene, within.detail, clip, 60, skinning).worst_m, 1.1 * 8.0) << seed;
    }
  }
  EXPECT_GT(left_out, 12u);
}

/// Vertices between two joints half a turn apart: only rounding decides which way dual quaternions bend them.
Scene half_turn_scene(std::uint64_t seed) {
  FixedRandom random(seed);
  Scene scene;
  scene.skeleton = chain_skeleton(4);
  scene.skeleton.rest[2].rotation = random.rotation();
  scene.skeleton.rest[3].rotation =
      normalised(quat_conjugate(scene.skeleton.rest[2].rotation) * quat_xyzw(0.36f, 0.48f, 0.8f, 0.0f));
  BoneAnimation turn{.joint = 1};
  turn.rotation = random_rotations(random, Interpolation::linear, random_times(random, 20));
  scene.animations.push_back(animation_of({turn}));
  scene.meshes = arm_scene().meshes;
  scene.skins.push_back({"half turn", {1, 3}, {Affine{}, Affine{}}, kNone});
  scene.instances.push_back({.joint = 0, .mesh = 0, .skin = 0, .rest_weights = {}});
  finish_scene(scene);
  return scene;
}

TEST(compile_skeleton_lod, N17_nothing_is_left_out_where_its_rounding_bends_vertices_to_the_other_side) {
  int bent = 0;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const Scene scene = half_turn_scene(seed);
    EXPECT_EQ(compile_skeleton_lod(scene, 1e-4).left_out, 2u) << "linear blending is indifferent to it";
    const CompiledSkeletonLod within =
        compile_skeleton_lod(scene, 1e-4, {}, {.skin = {.kind = Skinning::dual_quaternion}});
    EXPECT_EQ(within.tolerance_m, 1e-4);
    EXPECT_EQ(within.detail.kept.empty(), within.left_out == 0);
    bent += within.left_out == 0;
  }
  EXPECT_GT(bent, 1);
}

TEST(compile_skeleton_lod, a_skeleton_without_meshes_is_measured_at_its_shell) {
  Scene scene = clenched_scene({quat_identity<float>(), normalised(quat_xyzw(0.0f, 0.0f, 0.1f, 1.0f))});
  scene.instances.clear();
  scene.clips.clear();
  finish_scene(scene);
  EXPECT_TRUE(compile_skeleton_lod(scene, 1e-4).detail.kept.empty());
  EXPECT_FALSE(compile_skeleton_lod(scene, 0.02).detail.kept[2]);
}

TEST(compile_skeleton_lod, an_empty_scene_has_nothing_to_leave_out) {
  EXPECT_EQ(compile_skeleton_lod(Scene{}, 1.0).left_out, 0u);
}

TEST(compile_skeleton_lod, the_kind_of_skinning_of_each_instance_counts) {
  RandomSceneOptions options = without_morphs();
  options.centers = true;
  const Scene scene = random_scene(5, options);
  const auto skinned = static_cast<std::size_t>(
      std::find_if(scene.instances.begin(), scene.instances.end(), [](const auto& i) { return i.skin != kNone; }) -
      scene.instances.begin());
  ASSERT_LT(skinned, scene.instances.size());
  Needs others, own;
  others.skin.per_instance.assign(scene.instances.size(), Skinning::linear);
  own = others;
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    if (scene.instances[i].skin == kNone) others.skin.per_instance[i] = Skinning::dual_quaternion;
  own.skin.per_instance[skinned] = Skinning::dual_quaternion;
  const CompiledSkeletonLod linear = compile_skeleton_lod(scene, 8.0);
  EXPECT_EQ(compile_skeleton_lod(scene, 8.0, {}, others).measured_m, linear.measured_m)
      << "instances without a skin are not bent";
  EXPECT_NE(compile_skeleton_lod(scene, 8.0, {}, own).measured_m, linear.measured_m) << "compared vertex by vertex";
}

TEST(compile_skeleton_lod, a_single_joint_stays_and_its_shell_is_measured) {
  Scene scene;
  scene.skeleton = skeleton_of({kNone});
  BoneAnimation bone;
  bone.translation = {Interpolation::linear, {0, 1}, {{0, 0, 0}, {0, 2, 0}}};
  scene.animations.push_back(animation_of({bone}));
  finish_scene(scene);
  const CompiledSkeletonLod whole = compile_skeleton_lod(scene, 10.0);
  EXPECT_EQ(whole.left_out, 0u);
  EXPECT_TRUE(whole.detail.kept.empty());
  EXPECT_EQ(whole.measured_m, 0.0);
}

}  // namespace
}  // namespace sinew::test
