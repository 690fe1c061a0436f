// SPDX-License-Identifier: MIT
#include "runtime/compress/fit_keys.h"

#include <gtest/gtest.h>

#include <cmath>

#include "runtime/animation/track_sample.h"
#include "runtime/compress/clip_error.h"
#include "runtime/compress/drop_rows.h"
#include "runtime/compress/key_lists.h"
#include "tests/reference/clip_error.h"
#include "tests/scenes/skeletons.h"
#include "tests/scenes/swinging.h"

namespace sinew {
namespace {

constexpr Interpolation kEveryKind[] = {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline};

Scene scene_with(Skeleton skeleton, Animation animation) {
  Scene scene;
  scene.skeleton = std::move(skeleton);
  scene.animations.push_back(std::move(animation));
  finish_scene(scene);
  return scene;
}

/// A chain of bones of 0.2 m, each of which swings smoothly.
Scene swinging_chain(std::uint32_t joints, std::size_t keys) {
  Skeleton skeleton = test::chain_skeleton(joints);
  for (Transform& rest : skeleton.rest) rest.translation.y = 0.2f;
  Animation animation = scenes::swinging(skeleton, keys);
  return scene_with(std::move(skeleton), std::move(animation));
}

std::vector<reference::Matrix> reference_pose(const Skeleton& skeleton, const Animation& animation, double time_s) {
  std::vector<reference::LocalNumbers> local;
  for (const Transform& rest : skeleton.rest) local.push_back(reference::local_of(rest));
  for (const BoneAnimation& bone : animation.bones) {
    if (!bone.translation.empty()) local[bone.joint].translation = reference::sample(bone.translation, time_s);
    if (!bone.rotation.empty()) local[bone.joint].rotation = reference::sample(bone.rotation, time_s);
    if (!bone.scale.empty()) local[bone.joint].scale = reference::sample(bone.scale, time_s);
  }
  return reference::model_of(skeleton, local);
}

/// The largest distance of any virtual vertex at one time, by equations that share no code with the search.
double error_at(const Scene& scene, const Animation& written, const Animation& truth, const VirtualVertices& vertices,
                double time_s) {
  const auto a = reference_pose(scene.skeleton, truth, time_s), b = reference_pose(scene.skeleton, written, time_s);
  double largest = 0.0;
  for (std::size_t j = 0; j < a.size(); ++j)
    for (const Vec3<double>& corner : corners_of(vertices.boxes[j])) {
      double sum = 0.0;
      for (std::size_t r = 0; r < 3; ++r) {
        const reference::Real d = (b[j][r][0] - a[j][r][0]) * corner.x + (b[j][r][1] - a[j][r][1]) * corner.y +
                                  (b[j][r][2] - a[j][r][2]) * corner.z + (b[j][r][3] - a[j][r][3]);
        sum += static_cast<double>(d * d);
      }
      largest = std::max(largest, std::sqrt(sum));
    }
  return largest;
}

Animation random_animation(test::FixedRandom& random, std::uint32_t joints) {
  std::vector<BoneAnimation> bones;
  for (std::uint32_t j = 0; j < joints; ++j) {
    BoneAnimation bone;
    bone.joint = j;
    const auto times = test::random_times(random, 1 + random.below(30), random.below(4));
    bone.translation = test::random_vectors(random, kEveryKind[random.below(3)], times);
    bone.rotation = test::random_rotations(random, kEveryKind[random.below(3)], times);
    bone.scale = test::random_vectors(random, kEveryKind[random.below(3)], test::random_times(random, 5));
    bones.push_back(bone);
  }
  return test::animation_of(std::move(bones));
}

TEST(fit_keys, no_virtual_vertex_is_ever_farther_off_than_the_budget) {
  test::FixedRandom random(31);
  std::size_t smaller = 0;
  for (int round = 0; round < 30; ++round) {
    const Scene scene =
        round % 3 == 0 ? swinging_chain(6, 50) : scene_with(test::chain_skeleton(5), random_animation(random, 5));
    const Animation& truth = scene.animations[0];
    const VirtualVertices vertices = virtual_vertices(scene);
    const double budget_m = std::pow(10.0, random.in(-4, 0.5));
    const Animation kept = fit_keys(scene, truth, truth, vertices, budget_m);
    const ClipCertificate certificate = measure_keys(scene, kept, truth, vertices, budget_m);
    EXPECT_TRUE(certificate.is_met()) << round;
    EXPECT_LE(certificate.bytes, certificate.source_bytes);
    smaller += certificate.kept_keys < certificate.source_keys;
    for (int i = 0; i < 200; ++i) {
      const double time_s = random.in(-0.1, truth.duration_s + 0.1);
      ASSERT_LE(error_at(scene, kept, truth, vertices, time_s), budget_m * 1.03 + 1e-9) << round << " at " << time_s;
    }
    EXPECT_NEAR(error_at(scene, kept, truth, vertices, certificate.worst_time_s), certificate.measured_m,
                1e-7 * (1.0 + certificate.measured_m));
  }
  EXPECT_GT(smaller, 10u);
}

TEST(fit_keys, larger_budgets_leave_more_keys_out_and_most_of_a_budget_is_used) {
  const Scene scene = swinging_chain(8, 120);
  const VirtualVertices vertices = virtual_vertices(scene);
  std::uint64_t keys = 9 * 120;
  for (const double budget_m : {1e-3, 1e-2, 1e-1}) {
    const Animation kept = fit_keys(scene, scene.animations[0], scene.animations[0], vertices, budget_m);
    const ClipCertificate certificate = measure_keys(scene, kept, scene.animations[0], vertices, budget_m);
    EXPECT_LT(certificate.kept_keys, keys) << budget_m;
    EXPECT_GT(certificate.measured_m, 0.6 * budget_m);
    keys = certificate.kept_keys;
  }
  EXPECT_LT(keys, 9u * 20u);
}

TEST(fit_keys, a_budget_of_zero_keeps_every_key_and_holds) {
  const Scene scene = swinging_chain(4, 30);
  const VirtualVertices vertices = virtual_vertices(scene);
  const Animation kept = fit_keys(scene, scene.animations[0], scene.animations[0], vertices, 0.0);
  const ClipCertificate certificate = measure_keys(scene, kept, scene.animations[0], vertices, 0.0);
  EXPECT_EQ(certificate.measured_m, 0.0);
  EXPECT_TRUE(certificate.is_met());
  EXPECT_EQ(certificate.kept_keys, certificate.source_keys);
}

TEST(fit_keys, kept_keys_are_keys_of_the_file) {
  const Scene scene = swinging_chain(5, 60);
  const Animation& truth = scene.animations[0];
  const Animation kept = fit_keys(scene, truth, truth, virtual_vertices(scene), 5e-3);
  for (std::size_t b = 0; b < truth.bones.size(); ++b) {
    const QuatTrack &all = truth.bones[b].rotation, &some = kept.bones[b].rotation;
    ASSERT_LT(some.key_count(), all.key_count());
    for (std::size_t k = 0; k < some.key_count(); ++k) {
      const auto at = std::find(all.times_s.begin(), all.times_s.end(), some.times_s[k]);
      ASSERT_NE(at, all.times_s.end());
      EXPECT_EQ(some.values[k], all.values[static_cast<std::size_t>(at - all.times_s.begin())]);
    }
  }
}

TEST(fit_keys, tracks_that_hardly_move_keep_one_key_and_the_clip_its_length) {
  test::FixedRandom random(5);
  std::vector<BoneAnimation> bones(3);
  for (std::uint32_t j = 0; j < 3; ++j) {
    bones[j].joint = j;
    for (int k = 0; k < 60; ++k) {
      bones[j].translation.times_s.push_back(0.5f + static_cast<float>(k) / 30.0f);
      bones[j].translation.values.push_back(glm::vec3(1, 2, 3) + random.vec3(-1e-5, 1e-5));
    }
  }
  const Scene scene = scene_with(test::chain_skeleton(3), test::animation_of(std::move(bones)));
  const Animation kept = fit_keys(scene, scene.animations[0], scene.animations[0], virtual_vertices(scene), 1e-3);
  std::size_t keys = 0;
  float first = 1e9f, last = 0.0f;
  for (const BoneAnimation& bone : kept.bones) {
    keys += bone.translation.key_count();
    first = std::min(first, bone.translation.times_s.front());
    last = std::max(last, bone.translation.times_s.back());
  }
  EXPECT_EQ(keys, 4u);
  EXPECT_EQ(first, 0.5f);
  EXPECT_EQ(static_cast<double>(last), scene.animations[0].duration_s);
}

/// A chain whose joints stand at rest, but for the translation of one of them.
Scene mostly_resting(std::uint32_t moving) {
  Skeleton skeleton = test::chain_skeleton(4);
  for (Transform& rest : skeleton.rest) rest.translation.y = 0.2f;
  std::vector<BoneAnimation> bones;
  for (std::uint32_t j = 0; j < 4; ++j) {
    const Transform& rest = skeleton.rest[j];
    BoneAnimation& bone = bones.emplace_back();
    bone.joint = j;
    bone.translation = {Interpolation::linear, {0.5f, 2}, {rest.translation, rest.translation}};
    bone.rotation = {Interpolation::step, {1}, {rest.rotation}};
    bone.scale = {Interpolation::linear, {0, 1, 3}, {rest.scale, rest.scale, rest.scale}};
    if (j == moving) bone.translation.values[1].x += 1.0f;
  }
  return scene_with(std::move(skeleton), test::animation_of(std::move(bones)));
}

TEST(fit_keys, tracks_at_the_rest_transform_are_left_out) {
  Scene scene = mostly_resting(2);
  const Animation kept = fit_keys(scene, scene.animations[0], scene.animations[0], virtual_vertices(scene), 1e-3);
  for (std::uint32_t j = 0; j < 4; ++j) {
    EXPECT_EQ(kept.bones[j].translation.key_count(), j == 2 ? 2u : 0u);
    EXPECT_TRUE(kept.bones[j].rotation.empty());
  }
  EXPECT_EQ(measure_keys(scene, kept, scene.animations[0], virtual_vertices(scene), 1e-3).measured_m, 0.0);
  float first = 9.0f, last = 0.0f;
  for (const BoneAnimation& bone : kept.bones)
    for (const auto* times : {&bone.translation.times_s, &bone.scale.times_s})
      for (const float time : *times) {
        first = std::min(first, time);
        last = std::max(last, time);
      }
  EXPECT_EQ(first, 0.0f);
  EXPECT_EQ(last, 3.0f) << "one of the scales stays, since nothing else reaches the ends of the clip";

  scene.skeleton.rest[1].translation.z = 0.01f;  // a centimetre from its track
  const Animation apart = fit_keys(scene, scene.animations[0], scene.animations[0], virtual_vertices(scene), 1e-3);
  EXPECT_EQ(apart.bones[1].translation.key_count(), 1u);
}

TEST(fit_keys, a_clip_of_tracks_at_rest_keeps_one_of_them) {
  const Scene scene = mostly_resting(kNone);
  const Animation kept = fit_keys(scene, scene.animations[0], scene.animations[0], virtual_vertices(scene), 1e-3);
  std::size_t tracks = 0;
  for (const BoneAnimation& bone : kept.bones)
    tracks += !bone.translation.empty() + !bone.rotation.empty() + !bone.scale.empty();
  EXPECT_EQ(tracks, 1u);
  EXPECT_EQ(kept.bones[0].scale.times_s, (std::vector<float>{0, 3}));
}

TEST(fit_keys, a_cubic_track_that_rests_becomes_linear_since_it_has_one_key) {
  BoneAnimation bone;
  bone.translation.interpolation = Interpolation::cubic_spline;
  for (int k = 0; k < 10; ++k) {
    bone.translation.times_s.push_back(static_cast<float>(k));
    bone.translation.values.insert(bone.translation.values.end(), {glm::vec3(0), glm::vec3(1, 2, 3), glm::vec3(0)});
  }
  BoneAnimation moving;
  moving.joint = 1;
  moving.translation = {Interpolation::linear, {0, 9}, {glm::vec3(0), glm::vec3(9)}};
  const Scene scene = scene_with(test::chain_skeleton(2), test::animation_of({bone, moving}));
  const Animation kept = fit_keys(scene, scene.animations[0], scene.animations[0], virtual_vertices(scene), 1e-3);
  EXPECT_EQ(kept.bones[0].translation.interpolation, Interpolation::linear);
  EXPECT_EQ(kept.bones[0].translation.values, std::vector<glm::vec3>{glm::vec3(1, 2, 3)});
  EXPECT_EQ(check(kept.bones[0].translation), ErrorCode::ok);
}

TEST(fit_keys, both_sides_of_a_jump_stay_and_squad_keeps_every_key) {
  BoneAnimation bone;
  bone.translation = {Interpolation::linear, {0, 1, 1, 2}, {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}}};
  Scene scene = scene_with(test::chain_skeleton(1), test::animation_of({bone}));
  const Animation kept = fit_keys(scene, scene.animations[0], scene.animations[0], virtual_vertices(scene), 1e-2);
  EXPECT_EQ(sample_track<double>(kept.bones[0].translation, 0.999).x, 0.0);
  EXPECT_EQ(sample_track<double>(kept.bones[0].translation, 1.0).x, 1.0);

  Scene squad = swinging_chain(3, 20);
  for (BoneAnimation& each : squad.animations[0].bones) each.rotation.interpolation = Interpolation::squad;
  finish_scene(squad);
  const Animation& truth = squad.animations[0];
  const Animation same = fit_keys(squad, truth, truth, virtual_vertices(squad), 1e-2);
  for (std::size_t b = 0; b < 3; ++b) EXPECT_EQ(same.bones[b].rotation.key_count(), 20u);
}

TEST(fit_keys, keys_are_judged_as_a_reader_sees_them) {
  const Scene scene = swinging_chain(4, 60);
  const Animation& truth = scene.animations[0];
  const VirtualVertices vertices = virtual_vertices(scene);
  Animation stored = truth;
  for (BoneAnimation& bone : stored.bones)
    for (glm::quat& q : bone.rotation.values) q = glm::normalize(q * glm::quat(1.0f, 5e-4f, 0, 0));
  constexpr double kBudget = 2e-3;
  const Animation kept = fit_keys(scene, truth, stored, vertices, kBudget);
  const Animation plain = fit_keys(scene, truth, truth, vertices, kBudget);
  const auto keys = [](const Animation& animation) {
    std::size_t sum = 0;
    for (const BoneAnimation& bone : animation.bones) sum += bone.rotation.key_count();
    return sum;
  };
  EXPECT_GT(keys(kept), keys(plain)) << "rounding has used a part of the budget";
  Animation read = kept;
  for (BoneAnimation& bone : read.bones)
    for (glm::quat& q : bone.rotation.values) q = glm::normalize(q * glm::quat(1.0f, 5e-4f, 0, 0));
  EXPECT_LE(measure_keys(scene, read, truth, vertices, kBudget).measured_m, kBudget);
}

TEST(fit_keys, morph_weights_are_held_by_what_they_displace) {
  Scene scene = scene_with(test::chain_skeleton(1), {});
  Mesh mesh;
  mesh.primitives.resize(1);
  mesh.primitives[0].positions.assign(4, glm::vec3(0));
  mesh.default_weights.assign(1, 0.0f);
  mesh.primitives[0].morphs.targets.resize(1);
  mesh.primitives[0].morphs.targets[0].positions = {{1}, {{0, 2, 0}}};  // 2 m per weight
  scene.meshes.push_back(mesh);
  scene.instances.push_back({.joint = 0, .mesh = 0, .rest_weights = {0}});
  WeightAnimation animated;
  animated.weights = {Interpolation::linear, {}, {}, 1};
  for (int k = 0; k < 100; ++k) {
    animated.weights.times_s.push_back(static_cast<float>(k) / 30.0f);
    animated.weights.values.push_back(0.5f + 0.5f * std::sin(0.05f * static_cast<float>(k)));
  }
  scene.animations[0].weights.push_back(animated);
  scene.animations[0].duration_s = static_cast<double>(animated.weights.times_s.back());
  finish_scene(scene);
  const VirtualVertices vertices = virtual_vertices(scene);
  for (const double budget_m : {1e-2, 1e-4, 4.0}) {
    const Animation kept = fit_keys(scene, scene.animations[0], scene.animations[0], vertices, budget_m);
    const ClipCertificate certificate = measure_keys(scene, kept, scene.animations[0], vertices, budget_m);
    EXPECT_TRUE(certificate.is_met());
    EXPECT_EQ(certificate.weights_m, certificate.measured_m);
    EXPECT_EQ(certificate.kept_keys<20, budget_m> 1e-3);
    if (budget_m > 1.0) {
      EXPECT_EQ(certificate.kept_keys, 2u) << "one value, and the clip's end";
    }
    double apart = 0.0;
    for (int i = 0; i < 500; ++i) {
      const double time_s = scene.animations[0].duration_s * i / 499.0;
      double before[1], after[1];
      sample_track<double>(animated.weights, time_s, std::span<double>(before));
      sample_track<double>(kept.weights[0].weights, time_s, std::span<double>(after));
      apart = std::max(apart, 2.0 * std::abs(before[0] - after[0]));
    }
    EXPECT_LE(apart, budget_m);
  }
}

TEST(fit_keys, morph_weights_near_those_at_rest_are_left_out) {
  Scene scene = scene_with(test::chain_skeleton(1), {});
  Mesh mesh;
  mesh.primitives.resize(1);
  mesh.primitives[0].positions.assign(2, glm::vec3(0));
  mesh.default_weights.assign(2, 0.0f);
  mesh.primitives[0].morphs.targets.resize(2);
  for (MorphTarget& target : mesh.primitives[0].morphs.targets) target.positions = {{1}, {{0, 2, 0}}};
  scene.meshes.push_back(mesh);
  scene.instances.push_back({.joint = 0, .mesh = 0, .rest_weights = {0.25f, 1.0f}});
  WeightAnimation animated;
  animated.weights = {Interpolation::linear, {0, 0.5f, 1}, {0.2501f, 1.0f, 0.25f, 1.0001f, 0.25f, 1.0f}, 2};
  Animation& animation = scene.animations[0];
  animation.weights.push_back(animated);
  animation.bones.push_back({.joint = 0});
  animation.bones[0].translation = {Interpolation::linear, {0, 1}, {glm::vec3(0), glm::vec3(1)}};
  animation.duration_s = 1.0;
  finish_scene(scene);
  const VirtualVertices vertices = virtual_vertices(scene);
  EXPECT_TRUE(fit_keys(scene, animation, animation, vertices, 1e-2).weights[0].weights.empty());
  scene.instances[0].rest_weights = {0.25f, 0.5f};
  EXPECT_EQ(fit_keys(scene, animation, animation, vertices, 1e-2).weights[0].weights.key_count(), 1u);
}

TEST(fit_keys, long_animations_are_fitted_in_parts) {
  Skeleton tree = scenes::wide_tree(1100);
  Animation swing = scenes::swinging(tree, 200);  // more joints times times than are held at once
  const Scene scene = scene_with(std::move(tree), std::move(swing));
  const VirtualVertices vertices = virtual_vertices(scene);
  const Animation kept = fit_keys(scene, scene.animations[0], scene.animations[0], vertices, 0.5);
  const ClipCertificate certificate = measure_keys(scene, kept, scene.animations[0], vertices, 0.5);
  EXPECT_TRUE(certificate.is_met());
  EXPECT_LT(certificate.kept_keys, certificate.source_keys);
}

TEST(drop_rows, tracks_of_one_list_lose_keys_together_until_the_whole_pose_needs_them) {
  const Scene scene = swinging_chain(6, 80);
  const Animation& truth = scene.animations[0];
  const VirtualVertices vertices = virtual_vertices(scene);
  std::vector<KeptKeys> tracks;
  for (std::size_t b = 0; b < truth.bones.size(); ++b) {
    KeptKeys& track = tracks.emplace_back(KeptKeys{.track = 3 * b + 1});
    for (std::uint32_t key = 0; key < truth.bones[b].rotation.key_count(); ++key) track.keys.push_back(key);
  }
  const std::vector<double> times_s = times_to_check(truth, 6);
  const TruthSamples samples(scene, truth, vertices, times_s);
  constexpr double kBudget = 5e-3;
  drop_rows(truth, samples, kBudget, tracks);
  EXPECT_LT(tracks[0].keys.size(), 65u);
  for (const KeptKeys& track : tracks) EXPECT_EQ(track.keys, tracks[0].keys);
  EXPECT_LE(measure_animation(samples, with_keys(truth, tracks)).worst_m, kBudget);
  for (std::size_t row = 1; row + 1 < tracks[0].keys.size(); ++row) {
    std::vector<KeptKeys> fewer = tracks;
    for (KeptKeys& track : fewer) track.keys.erase(track.keys.begin() + static_cast<std::ptrdiff_t>(row));
    EXPECT_GT(measure_animation(samples, with_keys(truth, fewer)).worst_m, kBudget) << "row " << row;
  }
}

TEST(key_lists, tracks_share_key_times_where_that_takes_fewer_bytes) {
  std::vector<float> times;
  for (int k = 0; k < 40; ++k) times.push_back(static_cast<float>(k));
  std::vector<BoneAnimation> bones(2);
  for (std::uint32_t b = 0; b < 2; ++b) {
    bones[b].joint = b;
    bones[b].translation = {Interpolation::linear, times, std::vector<glm::vec3>(40)};
  }
  const Animation animation = test::animation_of(std::move(bones));
  const auto shared = [&](std::vector<std::uint32_t> a, std::vector<std::uint32_t> b) {
    std::vector<KeptKeys> tracks{{0, std::move(a)}, {3, std::move(b)}};
    const std::uint64_t before = bytes_in_file(with_keys(animation, tracks));
    share_key_times(animation, tracks);
    EXPECT_LE(bytes_in_file(with_keys(animation, tracks)), before);
    return tracks[0].keys == tracks[1].keys;
  };
  EXPECT_TRUE(shared({0, 10, 39}, {0, 20, 39})) << "one key more each costs less than another list";
  std::vector<std::uint32_t> even, odd{0};
  for (std::uint32_t k = 0; k < 40; ++k) (k % 2 == 0 ? even : odd).push_back(k);
  even.push_back(39);
  EXPECT_FALSE(shared(even, odd)) << "both would keep every key";
}

}  // namespace
}  // namespace sinew
