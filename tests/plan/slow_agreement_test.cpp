// SPDX-License-Identifier: MIT
// The plan and its jobs, compared with plain double-precision loops over the animations of random scenes.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/plan/slow_frame.h"
#include "tests/scenes/random_inputs.h"
#include "tests/scenes/random_scene.h"
#include "tests/scenes/stretches.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew::test {
namespace {

using Vec3d = Vec3<double>;

/// Largest distance of corresponding vectors, relative to 1 + their length.
template <class V>
double worst(std::span<const V> fast, const std::vector<Vec3d>& slow) {
  double found = 0.0;
  for (std::size_t v = 0; v < fast.size(); ++v) {
    const Vec3d f(static_cast<double>(fast[v].x), static_cast<double>(fast[v].y), static_cast<double>(fast[v].z));
    const double d = distance(f, slow[v]) / (1.0 + safe_length(slow[v]));
    if (!(d <= found)) found = d;
  }
  return found;
}

struct Errors {
  double model = 0, weights = 0, properties = 0, positions = 0, normals = 0, tangents = 0, colors = 0;
};

Errors compare(const FrameResult& fast, const SlowFrame& slow) {
  Errors e;
  for (std::size_t j = 0; j < fast.model.size(); ++j)
    e.model = std::max(e.model, distance(affine_cast<double>(fast.model[j]), slow.model[j]) /
                                    (1.0 + safe_length(translation_of(slow.model[j]))));
  for (std::size_t w = 0; w < fast.weights.size(); ++w)
    e.weights = std::max(e.weights, std::abs(static_cast<double>(fast.weights[w]) - slow.weights[w]));
  for (std::size_t i = 0; i < fast.properties.size(); ++i)
    e.properties = std::max(e.properties, std::abs(static_cast<double>(fast.properties[i]) - slow.properties[i]));
  for (std::size_t p = 0; p < fast.primitives.size(); ++p) {
    const DeformedPrimitive& shape = fast.primitives[p];
    e.positions = std::max(e.positions, worst(shape.positions, slow.primitives[p].positions));
    e.normals = std::max(e.normals, worst(shape.normals, slow.primitives[p].normals));
    e.tangents = std::max(e.tangents, worst(shape.tangents, slow.primitives[p].tangents));
    e.colors = std::max(e.colors, worst(shape.colors, [&] {
                          std::vector<Vec3d> rgb;
                          for (const auto& c : slow.primitives[p].colors) rgb.emplace_back(c.x, c.y, c.z);
                          return rgb;
                        }()));
  }
  return e;
}

struct Case {
  const char* name;
  Skinning skinning;
  NormalRule rule;
  bool flat, mirrored;
  bool in_tiles = false;  ///< vertices share joints, so that plans sort them
};

class SlowAgreement : public ::testing::TestWithParam<Case> {};

// Reason of the bounds: chains have up to ten joints of scale up to 1.25, at distances up to ten metres. Over 60 seeds
// the largest error is about a third of each bound. A normal of a sliver or of a blend that nearly cancels loses more
// digits, so its bound is wider.
TEST_P(SlowAgreement, run_plan_shows_what_plain_double_loops_give) {
  const Case& c = GetParam();
  for (std::uint64_t seed = 100; seed < 112; ++seed) {
    RandomSceneOptions options;
    options.flat_normals = c.flat;
    options.mirrored_joints = c.mirrored;
    options.centers = c.skinning == Skinning::center_of_rotation;
    if (c.in_tiles) {
      options.targets = 0;
      options.triangles = 150;
    }
    Scene scene = random_scene(seed, options);
    if (c.in_tiles) share_joints_in_stretches(scene, 32);
    Needs needs;
    needs.skin.kind = c.skinning;
    needs.skin.normal_rule = c.rule;
    const Plan plan = compile_plan(lend(scene), needs);
    FrameBuffer frame(plan);
    const ClipLayer layers[] = {{0, 0.31, 0.6f}, {1, 1.63, 0.3f}, {0, 5.0, 0.4f}};
    for (std::size_t count = 0; count <= 3; ++count) {
      FrameInput input{.layers = std::span(layers, count), .weights = {}, .root = {}};
      input.root.row[1].w = 2.0f;
      ASSERT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
      EXPECT_EQ(frame.result().work.vertices_skinned_in_tiles > 0, c.in_tiles);
      const SlowFrame slow = evaluate_slowly(scene, needs, input);
      const Errors e = compare(frame.result(), slow);
      EXPECT_LE(e.model, 3e-6) << "seed " << seed << " layers " << count;
      EXPECT_LE(e.weights, 3e-7) << "seed " << seed << " layers " << count;
      EXPECT_LE(e.positions, 3e-6) << "seed " << seed << " layers " << count;
      EXPECT_LE(e.normals, 2e-4) << "seed " << seed << " layers " << count;
      EXPECT_LE(e.tangents, 4e-5) << "seed " << seed << " layers " << count;
      EXPECT_LE(e.colors, 3e-7) << "seed " << seed << " layers " << count;
      for (std::size_t i = 0; i < scene.instances.size(); ++i)
        EXPECT_EQ(frame.result().instances[i].mirrored, slow.mirrored[i]) << "seed " << seed << " instance " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    kinds, SlowAgreement,
    ::testing::Values(
        Case{"linear", Skinning::linear, NormalRule::linear, false, false},
        Case{"linear_cofactor_mirrored", Skinning::linear, NormalRule::cofactor, false, true},
        Case{"linear_G46_flat_G48_mirrored", Skinning::linear, NormalRule::linear, true, true},
        Case{"linear_in_tiles", Skinning::linear, NormalRule::linear, false, false, true},
        Case{"linear_in_tiles_cofactor_G46_flat_mirrored", Skinning::linear, NormalRule::cofactor, true, true, true},
        Case{"linear_cofactor_G46_flat_mirrored", Skinning::linear, NormalRule::cofactor, true, true},
        Case{"dual_quaternion", Skinning::dual_quaternion, NormalRule::linear, false, false},
        Case{"center_of_rotation_N21", Skinning::center_of_rotation, NormalRule::linear, false, false},
        Case{"center_of_rotation_G46_flat_mirrored", Skinning::center_of_rotation, NormalRule::linear, true, true},
        Case{"dual_quaternion_G46_flat_mirrored", Skinning::dual_quaternion, NormalRule::linear, true, true}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(slow_agreement, squad_shows_what_plain_double_loops_give) {
  for (std::uint64_t seed = 230; seed < 236; ++seed) {
    Scene scene = random_scene(seed);
    std::size_t squads = 0;
    for (BoneAnimation& bone : scene.animations[0].bones)
      if (bone.rotation.interpolation == Interpolation::linear && !bone.rotation.empty()) {
        bone.rotation.interpolation = Interpolation::squad;
        ++squads;
      }
    ASSERT_GT(squads, 0u);
    scene.clips.clear();
    finish_scene(scene);
    const Plan plan = compile_plan(lend(scene), {});
    FrameBuffer frame(plan);
    for (const double time_s : {0.0, 0.03, 0.31, 0.9, 1.4, 1.98}) {
      const ClipLayer layer{0, time_s};
      const FrameInput input{.layers = {&layer, 1}, .weights = {}, .root = {}};
      ASSERT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
      const Errors e = compare(frame.result(), evaluate_slowly(scene, {}, input));
      EXPECT_LE(e.model, 3e-6) << "seed " << seed << " at " << time_s;
      EXPECT_LE(e.positions, 3e-6) << "seed " << seed << " at " << time_s;
    }
  }
}

TEST(slow_agreement, masked_and_added_layers_show_what_plain_double_loops_give) {
  for (std::uint64_t seed = 200; seed < 216; ++seed) {
    const Scene scene = random_scene(seed);
    FixedRandom random(seed);
    Needs needs;
    needs.in.additive = true;
    needs.in.max_layers = 2;
    needs.in.masks.resize(2);
    for (auto& mask : needs.in.masks)
      for (std::size_t j = 0; j < scene.skeleton.joint_count(); ++j)
        mask.push_back(random.below(4) == 0 ? 0.0f : static_cast<float>(random.unit()));
    const Plan plan = compile_plan(lend(scene), needs);
    FrameBuffer frame(plan);
    const ClipLayer layers[] = {{0, 0.31, 0.6f, 0},
                                {1, 1.63, 0.7f, 1},
                                {0, 0.9, 0.8f, kNone, LayerKind::add_to_start},
                                {1, 0.4, 0.5f, 1, LayerKind::add_to_rest},
                                {1, 0.8, 1.0f, 0},
                                {0, 0.6, 1.0f, 1, LayerKind::add_to_start},
                                {1, 0.5, -0.6f, 0, LayerKind::add_to_rest},
                                {0, 0.7, -1.0f, kNone, LayerKind::add_to_start}};
    for (const auto& [first, count] :
         {std::pair{0, 4}, {0, 1}, {1, 2}, {2, 2}, {3, 1}, {4, 1}, {3, 2}, {4, 2}, {5, 1}, {5, 2}, {6, 2}}) {
      const FrameInput input{
          .layers = std::span(layers).subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(count)),
          .weights = {},
          .root = {}};
      ASSERT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
      const Errors e = compare(frame.result(), evaluate_slowly(scene, needs, input));
      EXPECT_LE(e.model, 6e-6) << "seed " << seed << " layers " << first << ' ' << count;
      EXPECT_LE(e.weights, 6e-7) << "seed " << seed << " layers " << first << ' ' << count;
      EXPECT_LE(e.positions, 6e-6) << "seed " << seed << " layers " << first << ' ' << count;
    }
  }
}

/// Combines layers, masks, additive layers, interpolated updates, given weights and roots at random.
TEST(slow_agreement, any_valid_input_shows_what_plain_double_loops_give) {
  std::size_t between = 0, with_properties = 0;
  for (std::uint64_t seed = 300; seed < 330; ++seed) {
    const Scene scene = busy_scene(seed);
    Needs needs = busy_needs(seed, scene);
    needs.skin.kind = Skinning::linear;
    needs.skin.per_instance.clear();
    const Plan plan = compile_plan(lend(scene), needs);
    FrameBuffer frame(plan);
    RandomInputs inputs(plan);
    for (std::uint32_t step = 0; step < 40; ++step) {
      inputs.step(step + static_cast<std::uint32_t>(seed) * 1000);
      const FrameInput input = inputs.view();
      ASSERT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
      const Errors e = compare(frame.result(), evaluate_slowly(scene, needs, input));
      EXPECT_LE(e.model, 1e-5) << "seed " << seed << " step " << step;
      EXPECT_LE(e.weights, scene.correctives.empty() ? 1e-6 : 1e-5) << "seed " << seed << " step " << step;
      EXPECT_LE(e.properties, 1e-6) << "seed " << seed << " step " << step;
      EXPECT_LE(e.positions, 1e-5) << "seed " << seed << " step " << step;
      EXPECT_LE(e.colors, 2e-6) << "seed " << seed << " step " << step;
      between += input.interpolation_factor != 0.0f && !frame.result().model.empty();
      with_properties += !frame.result().properties.empty();
    }
  }
  EXPECT_GT(between, 100u);
  EXPECT_GT(with_properties, 100u);
}

/// Every mesh plays a vertex source, at any weight, in either space, with and without normals.
TEST(slow_agreement, instances_that_play_show_what_plain_double_loops_give) {
  for (std::uint64_t seed = 400; seed < 424; ++seed) {
    RandomSceneOptions options;
    options.flat_normals = seed % 3 == 0;
    options.mirrored_joints = seed % 2 == 0;
    options.triangles = 8;
    const Scene scene = random_scene(seed, options);
    WavingVertices waves(scene, seed);
    waves.space = seed % 5 < 2 ? VertexSpace::mesh : VertexSpace::scene;
    waves.has_normals = seed % 7 == 0;
    Needs needs;
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) needs.in.cached_instances.push_back(i);
    const Plan plan = compile_plan(lend(scene), needs);
    FrameBuffer frame(plan);
    const ClipLayer layer{0, 0.31, 1.0f};
    for (const float weight : {0.0f, 0.3f, 0.8f, 1.0f}) {
      const std::vector<GeometryInput> geometry(scene.instances.size(), {waves.source(), 0.7, weight});
      FrameInput input{.layers = {&layer, 1}, .weights = {}, .root = {}};
      input.geometry = geometry;
      input.root.row[1] = {0.0f, seed % 4 == 0 ? -1.5f : 1.25f, 0.0f, 2.0f};
      ASSERT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
      const SlowFrame slow = evaluate_slowly(scene, needs, input);
      const Errors e = compare(frame.result(), slow);
      EXPECT_LE(e.positions, weight == 1.0f ? 0.0 : 6e-6) << "seed " << seed << " weight " << weight;
      EXPECT_LE(e.normals, weight == 1.0f ? 1e-6 : 2e-4) << "seed " << seed << " weight " << weight;
      EXPECT_LE(e.tangents, weight == 1.0f ? 1e-5 : 4e-5) << "seed " << seed << " weight " << weight;
      for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        EXPECT_EQ(frame.result().instances[i].mirrored, slow.mirrored[i]) << "seed " << seed << " weight " << weight;
        EXPECT_LE(distance(affine_cast<double>(frame.result().instances[i].world_from_mesh), slow.world_from_mesh[i]) /
                      (1.0 + safe_length(translation_of(slow.world_from_mesh[i]))),
                  1e-5)
            << "seed " << seed << " weight " << weight;
      }
    }
  }
}

// The slow path shares no code with plans, clips and jobs. This test shows that its result depends on its input.
TEST(slow_frame, differs_when_its_input_differs) {
  const Scene scene = random_scene(7);
  const ClipLayer a{0, 0.5, 1.0f}, b{0, 0.6, 1.0f};
  const SlowFrame first = evaluate_slowly(scene, {}, {.layers = {&a, 1}, .weights = {}, .root = {}});
  const SlowFrame second = evaluate_slowly(scene, {}, {.layers = {&b, 1}, .weights = {}, .root = {}});
  EXPECT_GT(distance(first.primitives[0].positions[0], second.primitives[0].positions[0]), 1e-4);
  EXPECT_NE(first.weights, second.weights);
}

}  // namespace
}  // namespace sinew::test
