// SPDX-License-Identifier: MIT
#include "importer/tool/fit_clips.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <cmath>

#include "runtime/clip/clip_file.h"
#include "runtime/lod/clip_bounds.h"
#include "tests/scenes/skeletons.h"
#include "tests/scenes/swinging.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

constexpr double kBudget = 1e-3;

/// Clips of one skeleton, each of another length and speed, every second one with noise of another amplitude. Either
/// part of the search finds the smallest clip of some.
Scene scene_of_clips(std::size_t count) {
  Scene scene;
  scene.skeleton = scenes::long_chain(9);
  FixedRandom random(5);
  for (std::size_t c = 0; c < count; ++c) {
    scene.animations.push_back(scenes::swinging(scene.skeleton, 20 + 9 * c, 15.0 + 5.0 * static_cast<double>(c)));
    const double noise_rad = std::pow(10.0, -1.5 - 0.5 * static_cast<double>(c));
    for (BoneAnimation& bone : scene.animations.back().bones)
      for (glm::quat& q : bone.rotation.values)
        if (c % 2 == 1) q = q * random.rotation_by(noise_rad);
  }
  finish_scene(scene);
  return scene;
}

/// Runs `work` on that many threads.
template <class Work>
auto on_threads(std::size_t count, const Work& work) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, count);
  tbb::task_arena arena(static_cast<int>(count));
  return arena.execute(work);
}

std::vector<std::byte> saved(const Clip& clip) {
  const Clip* const one[] = {&clip};
  return save_clips(one);
}

TEST(fit_clips, does_not_depend_on_the_number_of_threads) {
  const Scene scene = scene_of_clips(7);
  const auto fit = [&] { return tool::fit_clips(scene, scene.animations, kBudget); };
  const std::vector<ClipWithin> alone = on_threads(1, fit);
  ASSERT_EQ(alone.size(), 7u);
  for (const std::size_t threads : {2u, 5u}) {
    const auto together = on_threads(threads, fit);
    ASSERT_EQ(together.size(), alone.size());
    for (std::size_t c = 0; c < alone.size(); ++c) {
      EXPECT_EQ(saved(together[c].clip), saved(alone[c].clip)) << threads << " threads, clip " << c;
      EXPECT_EQ(together[c].truth_poses, alone[c].truth_poses);
    }
  }
}

TEST(fit_clips, finds_what_the_search_of_one_clip_finds) {
  const Scene scene = scene_of_clips(7);
  const VirtualVertices vertices = virtual_vertices(scene);
  for (const double budget_m : {0.0, kBudget}) {
    const auto clips = tool::fit_clips(scene, scene.animations, budget_m);
    for (std::size_t c = 0; c < clips.size(); ++c) {
      const ClipWithin one = compile_clip_within(scene, scene.animations[c], vertices, budget_m);
      EXPECT_EQ(saved(clips[c].clip), saved(one.clip)) << c;
      EXPECT_EQ(clips[c].keys.bones[4].rotation.times_s, one.keys.bones[4].rotation.times_s);
    }
  }
}

TEST(certify_keys, measures_each_clip_against_its_own_truth_on_any_number_of_threads) {
  const Scene scene = scene_of_clips(4);
  std::vector<Animation> written = scene.animations;
  for (std::size_t c = 0; c < written.size(); ++c)
    written[c].bones[0].translation.values[3].y += 0.01f * static_cast<float>(c);
  const auto certify = [&] { return tool::certify_keys(scene, scene.animations, written, kBudget); };
  const auto alone = on_threads(1, certify), together = on_threads(3, certify);
  for (std::size_t c = 0; c < written.size(); ++c) {
    EXPECT_EQ(alone[c], together[c]) << c;
    EXPECT_NEAR(alone[c].measured_m, 0.01 * static_cast<double>(c), 1e-6);
  }
}

TEST(bound_clips, finds_the_boxes_of_each_clip_on_any_number_of_threads) {
  Scene scene = scene_of_clips(5);
  scene.meshes.resize(1);
  scene.meshes[0].primitives.resize(1);
  scene.meshes[0].primitives[0].positions = {{0, 0, 0}, {0.5f, 0, 0}};
  scene.instances.push_back({.joint = 8, .mesh = 0});
  finish_scene(scene);
  for (const std::size_t threads : {1u, 4u}) {
    const ClipBoxes boxes = on_threads(threads, [&] { return tool::bound_clips(scene); });
    ASSERT_EQ(boxes.size(), 5u);
    for (std::uint32_t c = 0; c < 5; ++c) {
      const Aabb box = clip_boxes(scene, c)[0];
      EXPECT_EQ(boxes[c][0].lower, box.lower) << c;
      EXPECT_EQ(boxes[c][0].upper, box.upper) << c;
    }
    EXPECT_NE(boxes[1][0].upper, boxes[2][0].upper);
  }
}

}  // namespace
}  // namespace sinew::test
