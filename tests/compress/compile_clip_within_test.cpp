// SPDX-License-Identifier: MIT
#include "runtime/compress/compile_clip_within.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "runtime/animation/track_sample.h"
#include "runtime/animation/truth_pose.h"
#include "runtime/clip/clip_file.h"
#include "runtime/clip/unpack_clip.h"
#include "runtime/compress/clip_error.h"
#include "runtime/math/quat_log_exp.h"
#include "tests/reference/clip_error.h"
#include "tests/scenes/skeletons.h"
#include "tests/scenes/swinging.h"

namespace sinew {
namespace {

constexpr Interpolation kPlayed[] = {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline};

Scene scene_of(Skeleton skeleton, Animation animation) {
  Scene scene;
  scene.skeleton = std::move(skeleton);
  scene.animations.push_back(std::move(animation));
  finish_scene(scene);
  return scene;
}

/// A chain of bones of 0.2 that sways smoothly, with some noise, sampled at `fps`.
Scene swaying(std::uint32_t joints, std::size_t keys, float fps, double noise_rad, std::uint64_t seed = 7) {
  test::FixedRandom random(seed);
  Skeleton skeleton = test::chain_skeleton(joints);
  for (Transform& rest : skeleton.rest) rest.translation.y = 0.2f;
  std::vector<BoneAnimation> bones(joints);
  for (std::uint32_t j = 0; j < joints; ++j) {
    bones[j].joint = j;
    for (std::size_t k = 0; k < keys; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(fps);
      bones[j].rotation.times_s.push_back(static_cast<float>(t));
      const Vec3<double> axis(0.3 * std::sin(2.0 * t + j) + noise_rad * random.normal(), noise_rad * random.normal(),
                              0.2 * std::cos(1.3 * t));
      bones[j].rotation.values.push_back(quat_cast<float>(quat_exp(axis)));
    }
  }
  return scene_of(std::move(skeleton), test::animation_of(std::move(bones)));
}

/// What keys whose length is off by a rounding, and float poses, may change: in proportion to the largest number of the
/// pose.
double noise_of(const Scene& scene, const Animation& truth, double time_s) {
  TruthPose pose;
  evaluate_truth(truth, scene.skeleton, time_s, pose);
  double largest = 1.0;
  for (const Affined& m : pose.model)
    for (const auto& row : m.row)
      largest = std::max({largest, std::abs(row.x), std::abs(row.y), std::abs(row.z), std::abs(row.w)});
  return 1e-6 * largest;
}

/// Fails when the certificate is wrong: at a hundred random times nothing of the clip, packed or not, is farther off
/// than it says (but for `margin`, what lies between the times that it was measured at), and where it has its worst
/// case the same error is found.
void expect_honest(const Scene& scene, const Animation& truth, const VirtualVertices& vertices, const Clip& clip,
                   double margin = 1.03) {
  ASSERT_TRUE(clip.certificate());
  const ClipCertificate& c = *clip.certificate();
  const Clip full = unpacked(clip);
  const auto errors = [&](double time_s) {
    auto larger = reference::joint_errors(scene.skeleton, truth, vertices.boxes, clip, time_s);
    const auto of_full = reference::joint_errors(scene.skeleton, truth, vertices.boxes, full, time_s);
    for (std::size_t j = 0; j < larger.size(); ++j) larger[j] = std::max(larger[j], of_full[j]);
    return larger;
  };
  test::FixedRandom random(99);
  for (int i = 0; i < 100; ++i) {
    const double time_s = random.in(-0.1, truth.duration_s + 0.1);
    for (const auto error : errors(time_s))
      ASSERT_LE(static_cast<double>(error), c.measured_m * margin + noise_of(scene, truth, time_s)) << "at " << time_s;
  }
  if (c.worst_joint == kNone) return;
  EXPECT_NEAR(static_cast<double>(errors(c.worst_time_s)[c.worst_joint]), c.measured_m,
              noise_of(scene, truth, c.worst_time_s));
}

TEST(compile_clip_within, certificate_is_what_an_independent_evaluation_finds) {
  for (const double noise : {0.0, 1e-4, 1e-2}) {
    const Scene scene = swaying(12, 90, 30.0f, noise);
    const VirtualVertices vertices = virtual_vertices(scene);
    for (const double budget : {1e-2, 1e-4}) {
      const ClipWithin within = compile_clip_within(scene, scene.animations[0], vertices, budget);
      EXPECT_TRUE(within.clip.certificate()->is_met());
      EXPECT_EQ(within.clip.certificate()->asked_m, budget);
      EXPECT_LE(within.clip.certificate()->measured_m, budget);
      expect_honest(scene, scene.animations[0], vertices, within.clip);
    }
  }
}

TEST(compile_clip_within, smaller_budgets_never_take_fewer_bytes_and_large_ones_leave_most_keys_out) {
  const Scene scene = swaying(10, 120, 60.0f, 1e-5);
  const VirtualVertices vertices = virtual_vertices(scene);
  std::size_t before = 0;
  for (const double budget : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const ClipWithin within = compile_clip_within(scene, scene.animations[0], vertices, budget);
    EXPECT_GE(saved_bytes(within.clip), before) << budget;
    before = saved_bytes(within.clip);
    EXPECT_EQ(within.clip.certificate()->bytes, before);
    EXPECT_TRUE(budget < 1e-2 || within.clip.certificate()->bytes * 20 < within.clip.certificate()->source_bytes);
  }
  EXPECT_LE(before, saved_bytes(scene.clips[0]));
}

TEST(compile_clip_within, G06_a_budget_of_zero_keeps_every_key_bit_for_bit) {
  test::FixedRandom random(3);
  std::vector<BoneAnimation> bones;
  for (std::uint32_t j = 0; j < 9; ++j) {
    BoneAnimation bone;
    bone.joint = j;
    const auto times = test::random_times(random, 12);
    bone.translation = test::random_vectors(random, kPlayed[j % 3], times);
    bone.rotation = test::random_rotations(random, kPlayed[(j + 1) % 3], times);
    bones.push_back(bone);
  }
  const Scene scene = scene_of(test::chain_skeleton(9), test::animation_of(std::move(bones)));
  const ClipWithin within = compile_clip_within(scene, scene.animations[0], virtual_vertices(scene), 0.0);
  test::PoseBuffer a(9), b(9);
  for (int i = 0; i < 50; ++i) {
    const double time_s = random.in(0, scene.animations[0].duration_s);
    EXPECT_EQ(run(SampleClipJob{.clip = &scene.clips[0], .time_s = time_s, .pose = a.span(), .weights = {}}),
              ErrorCode::ok);
    EXPECT_EQ(run(SampleClipJob{.clip = &within.clip, .time_s = time_s, .pose = b.span(), .weights = {}}),
              ErrorCode::ok);
    for (std::size_t j = 0; j < 9; ++j) EXPECT_EQ(a.span().get(j), b.span().get(j));
  }
  EXPECT_EQ(within.clip.certificate()->kept_keys, within.clip.certificate()->source_keys);
}

TEST(compile_clip_within, C13_an_error_of_a_parent_counts_at_all_vertices_below_it) {
  // One bent joint at the root of a chain of 2 m: the same bend may be ten times as wrong with a chain of 0.2 m.
  std::uint64_t bytes_long = 0, bytes_short = 0;
  for (const float bone_m : {0.2f, 0.02f}) {
    Scene scene = swaying(10, 120, 30.0f, 0.0);
    for (Transform& rest : scene.skeleton.rest) rest.translation.y = bone_m;
    scene.animations[0].bones.resize(1);
    finish_scene(scene);
    const ClipWithin within = compile_clip_within(scene, scene.animations[0], virtual_vertices(scene), 2e-3);
    (bone_m > 0.1f ? bytes_long : bytes_short) = within.clip.certificate()->bytes;
    EXPECT_LE(within.clip.certificate()->measured_m, 2e-3);
  }
  EXPECT_GT(bytes_long, bytes_short * 3 / 2);
}

TEST(compile_clip_within, G07_G13_N24_hard_tracks_of_every_interpolation_stay_within_any_budget) {
  test::FixedRandom random(11);
  for (int round = 0; round < 12; ++round) {
    std::vector<BoneAnimation> bones;
    for (std::uint32_t j = 0; j < 8; ++j) {
      BoneAnimation bone;
      bone.joint = j;
      const auto times = test::random_times(random, 1 + random.below(30), random.below(4));
      bone.translation = test::random_vectors(random, kPlayed[random.below(3)], times);
      bone.rotation = test::random_rotations(random, kPlayed[random.below(3)], times);
      bone.scale = test::random_vectors(random, kPlayed[random.below(3)], test::random_times(random, 5));
      bones.push_back(bone);
    }
    const Scene scene = scene_of(test::chain_skeleton(8), test::animation_of(std::move(bones)));
    const VirtualVertices vertices = virtual_vertices(scene);
    const double budget = std::pow(10.0, random.in(-4, 1));
    const ClipWithin within = compile_clip_within(scene, scene.animations[0], vertices, budget);
    EXPECT_TRUE(within.clip.certificate()->is_met() ||
                within.clip.certificate()->kept_keys == within.clip.certificate()->source_keys);
    if (within.clip.certificate()->is_met())
      expect_honest(scene, scene.animations[0], vertices, within.clip, budget / within.clip.certificate()->measured_m);
  }
}

TEST(compile_clip_within, N02_half_turns_between_keys_are_not_smoothed_away) {
  BoneAnimation bone;
  for (int k = 0; k < 40; ++k) {
    const double a = k % 2 == 0 ? 0.0 : M_PI / 2 * 0.9999;
    bone.rotation.times_s.push_back(static_cast<float>(k) / 30.0f);
    bone.rotation.values.push_back(
        quat_xyzw(static_cast<float>(std::sin(a)), 0.0f, 0.0f, static_cast<float>(std::cos(a))));
  }
  const Scene scene = scene_of(test::chain_skeleton(3), test::animation_of({bone}));
  const VirtualVertices vertices = virtual_vertices(scene);
  const ClipWithin within = compile_clip_within(scene, scene.animations[0], vertices, 1e-3);
  EXPECT_EQ(within.clip.certificate()->kept_keys, 40u);
  expect_honest(scene, scene.animations[0], vertices, within.clip);
}

TEST(compile_clip_within, squad_keeps_every_key) {
  Scene scene = swaying(4, 30, 30.0f, 0.0);
  for (BoneAnimation& bone : scene.animations[0].bones) bone.rotation.interpolation = Interpolation::squad;
  finish_scene(scene);
  const ClipWithin within = compile_clip_within(scene, scene.animations[0], virtual_vertices(scene), 1e-2);
  EXPECT_EQ(within.clip.certificate()->kept_keys, 120u);
  EXPECT_TRUE(within.clip.certificate()->is_met());
}

TEST(compile_clip_within, ten_thousand_joints_and_an_hour_are_kept) {
  Skeleton tree = scenes::wide_tree(10'000);
  Animation swing = scenes::swinging(tree, 2);
  const Scene wide = scene_of(std::move(tree), std::move(swing));
  const ClipWithin within = compile_clip_within(wide, wide.animations[0], virtual_vertices(wide), 0.1);
  EXPECT_LE(within.clip.certificate()->measured_m, 0.1);

  const Scene hour = swaying(2, 1200, 1.0f / 3.0f, 1e-3);
  const ClipWithin kept = compile_clip_within(hour, hour.animations[0], virtual_vertices(hour), 1e-3);
  EXPECT_LE(kept.clip.certificate()->measured_m, 1e-3);
  EXPECT_EQ(kept.clip.duration_s(), hour.animations[0].duration_s);
}

TEST(compile_clip_within, tracks_that_hardly_move_become_constant_and_the_clip_keeps_its_length) {
  test::FixedRandom random(5);
  BoneAnimation bone;
  for (int k = 0; k < 60; ++k) {
    bone.translation.times_s.push_back(static_cast<float>(k) / 30.0f);
    bone.translation.values.push_back(glm::vec3(1, 2, 3) + random.vec3(-4e-5, 4e-5));
  }
  const Scene scene = scene_of(test::chain_skeleton(2), test::animation_of({bone}));
  const ClipWithin within = compile_clip_within(scene, scene.animations[0], virtual_vertices(scene), 1e-4);
  EXPECT_EQ(within.clip.counts().time_groups, 0u);
  EXPECT_EQ(within.clip.counts().folded, 1u);
  EXPECT_EQ(within.keys.bones[0].end_time(), bone.end_time());
  EXPECT_EQ(within.clip.duration_s(), scene.animations[0].duration_s);
}

TEST(compile_clip_within, morph_weights_are_held_by_what_they_displace) {
  test::FixedRandom random(8);
  Scene scene = scene_of(test::chain_skeleton(1), {});
  Mesh mesh;
  mesh.primitives.resize(1);
  mesh.primitives[0].positions.assign(4, glm::vec3(0));
  mesh.default_weights.assign(2, 0.0f);
  mesh.primitives[0].morphs.targets.resize(2);
  mesh.primitives[0].morphs.targets[0].positions = {{1}, {{0, 2, 0}}};       // 2 m per weight
  mesh.primitives[0].morphs.targets[1].positions = {{2}, {{0.001f, 0, 0}}};  // 1 mm
  scene.meshes.push_back(mesh);
  scene.instances.push_back({.joint = 0, .mesh = 0, .rest_weights = {0, 0}});
  WeightAnimation animated;
  animated.weights = {Interpolation::linear, {}, {}, 2};
  for (int k = 0; k < 100; ++k) {
    animated.weights.times_s.push_back(static_cast<float>(k) / 30.0f);
    animated.weights.values.push_back(0.5f + 0.5f * std::sin(0.05f * static_cast<float>(k)));
    animated.weights.values.push_back(static_cast<float>(random.unit()));
  }
  scene.animations[0].weights.push_back(animated);
  scene.animations[0].duration_s = static_cast<double>(animated.weights.times_s.back());
  finish_scene(scene);
  const VirtualVertices vertices = virtual_vertices(scene);
  EXPECT_FLOAT_EQ(vertices.metres_per_weight[0], 2.0f);
  EXPECT_FLOAT_EQ(vertices.metres_per_weight[1], 0.001f);
  for (const double budget : {1e-2, 1e-4}) {
    const ClipWithin within = compile_clip_within(scene, scene.animations[0], vertices, budget);
    const ClipCertificate& c = *within.clip.certificate();
    EXPECT_LE(c.measured_m, budget);
    EXPECT_GT(c.weights_m, 0.0);
    EXPECT_EQ(c.bytes * 4 < c.source_bytes, budget > 1e-3)
        << "the jittering target moves nothing by more than a millimetre";
    float weights[2];
    test::PoseBuffer pose(1);
    for (int i = 0; i < 200; ++i) {
      const double t = random.in(0, scene.animations[0].duration_s);
      EXPECT_EQ(run(SampleClipJob{.clip = &within.clip, .time_s = t, .pose = pose.span(), .weights = weights}),
                ErrorCode::ok);
      double expected[2];
      sample_track<double>(animated.weights, t, std::span<double>(expected));
      EXPECT_LE(2 * std::abs(weights[0] - expected[0]) + 1e-3 * std::abs(weights[1] - expected[1]), budget);
    }
  }
}

TEST(compile_clip_within, a_joint_without_extent_keeps_its_scale_as_it_is) {
  // Its vertices lie in a plane whatever the scale; nothing says by how much a wrong scale would move them.
  BoneAnimation bone;
  test::FixedRandom random(21);
  for (int k = 0; k < 20; ++k) {
    bone.scale.times_s.push_back(static_cast<float>(k));
    bone.scale.values.push_back({1.0f + 1e-3f * static_cast<float>(random.unit()), 0.0f, 1.0f});
  }
  const Scene scene = scene_of(test::chain_skeleton(1), test::animation_of({bone}));
  const ClipWithin within = compile_clip_within(scene, scene.animations[0], virtual_vertices(scene), 1.0);
  EXPECT_EQ(within.keys.bones[0].scale.values, bone.scale.values);
}

TEST(compile_clip_within, a_joint_that_several_animations_move_counts_once) {
  test::FixedRandom random(22);
  const auto times = test::random_times(random, 3);
  std::vector<BoneAnimation> bones(4);
  bones[0].joint = bones[2].joint = 1;
  bones[0].rotation = test::random_rotations(random, Interpolation::linear, times);
  bones[1].joint = 0;
  bones[1].rotation = bones[0].rotation;
  bones[2].translation = test::random_vectors(random, Interpolation::linear, times);
  bones[3].joint = 2;  // without tracks
  const Scene scene = scene_of(test::chain_skeleton(3), test::animation_of(bones));
  const VirtualVertices vertices = virtual_vertices(scene);
  const Clip clip = compile_and_measure(scene, scene.animations[0], scene.animations[0], vertices, 0.5);
  EXPECT_EQ(clip.certificate()->animated_joints, 2u);
  EXPECT_EQ(clip.certificate()->source_keys, 9u);
  EXPECT_EQ(clip.certificate()->kept_keys, 9u);
  EXPECT_EQ(clip.certificate()->asked_m, 0.5);
}

}  // namespace
}  // namespace sinew
