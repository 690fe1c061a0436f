// SPDX-License-Identifier: MIT
// Correctives as a stage of the plan: when it runs, what it adds, and its cost when it does not run.
#include <gtest/gtest.h>

#include <cmath>

#include "runtime/plan/run_plan.h"
#include "runtime/pose/correct_pose.h"
#include "tests/plan/plan_dump.h"
#include "tests/plan/slow_frame.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/scenes/pose_samples.h"
#include "tests/scenes/random_scene.h"
#include "tests/support/near.h"

namespace sinew::test {
namespace {

/// The face of hand_scenes.h. A turn of its only joint by 90 degrees about z drives "lift" from 0 to 1.
Scene face_that_bends() {
  Scene scene = face_scene();
  PoseSamples samples;
  samples.drivers = {{.joint = 0}};
  samples.rotations = {about_z(0.0), about_z(1.5707963267948966)};
  samples.weights = {0};
  samples.values = {0.0f, 1.0f};
  scene.correctives.push_back(solve_corrective(samples).value());
  EXPECT_EQ(check(scene), ErrorCode::ok);
  return scene;
}

std::vector<float> weights_of(const Scene& scene, const Needs& needs, const FrameInput& input) {
  const Plan plan = compile_plan(lend(scene), needs);
  FrameBuffer frame(plan);
  EXPECT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
  return {frame.result().weights.begin(), frame.result().weights.end()};
}

TEST(correctives, add_to_rest_sampled_and_given_weights) {
  Scene scene = face_that_bends();
  const ClipLayer layer{0, 0.5, 1.0f};
  const std::vector<float> given = {-2.0f, 3.0f};
  EXPECT_EQ(weights_of(scene, {}, {}), (std::vector<float>{0.25f, 0.0f}));
  scene.skeleton.rest[0].rotation = about_z(1.5707963267948966);
  finish_scene(scene);
  EXPECT_EQ(weights_of(scene, {}, {}), (std::vector<float>{1.25f, 0.0f}));
  EXPECT_EQ(weights_of(scene, {}, {.layers = {&layer, 1}, .weights = {}, .root = {}}),
            (std::vector<float>{1.5f, 1.0f}));
  EXPECT_EQ(weights_of(scene, {}, {.layers = {}, .weights = given, .root = {}}), (std::vector<float>{-1.0f, 3.0f}));
}

TEST(correctives, run_when_weights_or_morphed_vertices_are_asked_for_and_say_why) {
  const Scene scene = face_that_bends();
  Needs needs;
  const PlanStage runs = stage(compile_plan(lend(scene), needs), "correctives");
  EXPECT_TRUE(runs.runs);
  EXPECT_EQ(runs.reason, "1 corrective adds to morph weights");
  EXPECT_EQ(runs.count, 2u);
  EXPECT_EQ(runs.bytes, sizeof(double) * scratch_size(scene.correctives[0]));
  needs.out.weights = false;
  EXPECT_TRUE(stage(compile_plan(lend(scene), needs), "correctives").runs);
  needs.out.positions = needs.out.normals = needs.out.tangents = false;
  const PlanStage left_out = stage(compile_plan(lend(scene), needs), "correctives");
  EXPECT_FALSE(left_out.runs);
  EXPECT_EQ(left_out.reason, "neither morph weights nor morphed vertices are asked for");
  EXPECT_EQ(left_out.bytes, 0u);
  needs.out.weights = true;
  EXPECT_TRUE(stage(compile_plan(lend(scene), needs), "correctives").runs);
}

TEST(correctives, move_the_vertices_of_the_frame) {
  Scene scene = face_that_bends();
  scene.skeleton.rest[0].rotation = about_z(1.5707963267948966);
  finish_scene(scene);
  const Plan plan = compile_plan(lend(scene), {});
  FrameBuffer frame(plan);
  ASSERT_EQ(run_plan(plan, {}, frame), ErrorCode::ok);
  EXPECT_EQ(frame.result().primitives[0].positions[0].z, 1.25f);
}

TEST(correctives, a_scene_with_a_bad_index_is_refused) {
  Scene scene = face_that_bends();
  scene.correctives[0].samples.weights[0] = 2;
  EXPECT_EQ(check(scene), ErrorCode::index_out_of_range);
}

// Reason of the bounds: poses are off by 3e-7 rad, correctives have slopes of up to ten per radian, and there are two.
TEST(correctives, agree_with_plain_double_loops) {
  for (std::uint64_t seed = 300; seed < 312; ++seed) {
    RandomSceneOptions options;
    options.correctives = 2;
    const Scene scene = random_scene(seed, options);
    const Plan plan = compile_plan(lend(scene), {});
    FrameBuffer frame(plan);
    const ClipLayer layers[] = {{0, 0.31, 0.6f}, {1, 1.63, 0.3f}};
    double added = 0.0;
    for (std::size_t count = 0; count <= 2; ++count) {
      const FrameInput input{.layers = std::span(layers, count), .weights = {}, .root = {}};
      ASSERT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
      const SlowFrame slow = evaluate_slowly(scene, {}, input);
      Scene without = random_scene(seed, options);
      without.correctives.clear();
      const SlowFrame plain = evaluate_slowly(without, {}, input);
      for (std::size_t w = 0; w < slow.weights.size(); ++w) {
        EXPECT_NEAR(static_cast<double>(frame.result().weights[w]), slow.weights[w], 5e-6) << "seed " << seed;
        added = std::max(added, std::abs(slow.weights[w] - plain.weights[w]));
      }
      for (std::size_t p = 0; p < plan.primitives().size(); ++p)
        for (std::size_t v = 0; v < frame.result().primitives[p].positions.size(); ++v)
          EXPECT_TRUE(is_near(Vec3<double>(frame.result().primitives[p].positions[v]), slow.primitives[p].positions[v],
                              2e-5 * (1.0 + safe_length(slow.primitives[p].positions[v]))));
    }
    EXPECT_GT(added, 0.01) << "seed " << seed;
  }
}

}  // namespace
}  // namespace sinew::test
