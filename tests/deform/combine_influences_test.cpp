// SPDX-License-Identifier: MIT
#include "runtime/deform/combine_influences.h"

#include <gtest/gtest.h>

#include "runtime/plan/frame_hash.h"
#include "runtime/plan/run_plan.h"
#include "tests/plan/changed_plan.h"
#include "tests/plan/plan_dump.h"
#include "tests/scenes/random_scene.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/simd_targets.h"

namespace sinew::test {
namespace {

/// `copies` copies of each of `distinct` vertices; each has its own pair of joints.
VertexInfluences repeated_pairs(std::uint32_t distinct, std::uint32_t copies) {
  VertexInfluences influences;
  influences.groups = {{0, distinct * copies, 2, 0}};
  for (std::uint32_t v = 0; v < distinct * copies; ++v) {
    const auto joint = static_cast<std::uint16_t>(v % distinct);
    influences.joints.insert(influences.joints.end(), {joint, static_cast<std::uint16_t>(joint + 1)});
    influences.weights.insert(influences.weights.end(), {0.75f, 0.25f});
  }
  return influences;
}

RandomSceneOptions repeating(std::uint64_t seed) {
  RandomSceneOptions options;
  options.combinations = 2;
  options.triangles = 300;
  options.most_influences = 3 + static_cast<std::uint32_t>(seed % 3);
  options.instances = 6;
  options.mirrored_joints = seed % 2 == 1;
  options.targets = seed % 3 == 0 ? 2 : 0;
  return options;
}

TEST(combine_influences, C06_every_vertex_keeps_its_joints_and_weights) {
  const Scene scene = random_scene(4, repeating(4));
  const std::uint32_t first_matrix = 20;
  for (const Mesh& mesh : scene.meshes)
    for (const Primitive& primitive : mesh.primitives) {
      const VertexInfluences& source = primitive.influences;
      const CombinedInfluences combined = combine_influences(source, first_matrix);
      ASSERT_TRUE(combined.used());
      const auto combination = [&](std::uint32_t index) {
        for (const InfluenceGroup& g : combined.combinations.groups)
          if (index - g.first_vertex < g.vertex_count) {
            const auto at = static_cast<std::ptrdiff_t>(g.first_influence +
                                                        (index - g.first_vertex) * g.influence_count),
                       end = at + g.influence_count;
            return std::pair(
                std::vector(combined.combinations.joints.begin() + at, combined.combinations.joints.begin() + end),
                std::vector(combined.combinations.weights.begin() + at, combined.combinations.weights.begin() + end));
          }
        return std::pair(std::vector<std::uint16_t>(), std::vector<float>());
      };
      for (const InfluenceGroup& g : source.groups)
        for (std::uint32_t v = 0; v < g.vertex_count; ++v) {
          const auto at = static_cast<std::ptrdiff_t>(g.first_influence + v * g.influence_count),
                     end = at + g.influence_count;
          const std::uint16_t matrix = combined.vertices.joints[g.first_vertex + v];
          if (g.influence_count == 1) {
            EXPECT_EQ(matrix, source.joints[static_cast<std::size_t>(at)]);
            continue;
          }
          ASSERT_GE(matrix, first_matrix);
          EXPECT_EQ(combination(matrix - first_matrix),
                    std::pair(std::vector(source.joints.begin() + at, source.joints.begin() + end),
                              std::vector(source.weights.begin() + at, source.weights.begin() + end)));
        }
    }
}

TEST(combine_influences, C06_wins_only_where_many_vertices_share_a_combination) {
  EXPECT_FALSE(combine_influences(repeated_pairs(10, 5), 11).used());
  EXPECT_TRUE(combine_influences(repeated_pairs(10, 6), 11).used());
  const CombinedInfluences counted = combine_influences(repeated_pairs(10, 5), 11);
  EXPECT_EQ(counted.blended_vertices, 50u);
  EXPECT_EQ(counted.combination_count, 10u);
  EXPECT_TRUE(counted.combinations.empty()) << "no memory for what is not used";
  EXPECT_TRUE(combine_influences(repeated_pairs(10, 6), 8182).used());
  EXPECT_FALSE(combine_influences(repeated_pairs(10, 6), 8183).used()) << "more matrices than a cache holds";
  VertexInfluences rigid;
  rigid.groups = {{0, 100, 1, 0}};
  rigid.joints.assign(100, 3);
  rigid.weights.assign(100, 1.0f);
  EXPECT_FALSE(combine_influences(rigid, 11).used());
  EXPECT_FALSE(combine_influences({}, 11).used());
}

TEST(combine_influences, weights_of_other_bits_are_another_combination) {
  VertexInfluences influences = repeated_pairs(1, 12);
  influences.weights[2 * 7] = 0.75000006f;
  EXPECT_EQ(combine_influences(influences, 2).combination_count, 2u);
}

/// Compares frames with and without combined influences.
void expect_same_vertices(const Scene& scene, const Needs& needs) {
  const Plan combined = compile_plan(lend(scene), needs), plain = without_combinations(combined);
  ASSERT_TRUE(stage(combined, "combinations").runs);
  FrameBuffer with(combined), without(plain);
  for (const double time_s : {0.0, 0.3, 1.1}) {
    const ClipLayer layer{0, time_s, 1.0f};
    const FrameInput input{.layers = {&layer, 1}, .weights = {}, .root = {}};
    ASSERT_EQ(run_plan(combined, input, with), ErrorCode::ok);
    ASSERT_EQ(run_plan(plain, input, without), ErrorCode::ok);
    if (with.result().frame == 1) {
      EXPECT_EQ(with.result().work.combinations_blended, stage(combined, "combinations").count);
    }
    EXPECT_EQ(without.result().work.combinations_blended, 0u);
    EXPECT_EQ(hash_vertices(with.result()), hash_vertices(without.result())) << time_s;
    EXPECT_EQ(hash_pose(with.result()), hash_pose(without.result()));
  }
}

TEST(combinations_in_frames, C06_give_the_bits_of_vertices_that_blend_for_themselves) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Scene scene = random_scene(seed, repeating(seed));
    for (const std::int64_t target : simd_targets()) {
      const OnlyTarget only(target);
      Needs needs;
      needs.skin.normal_rule = seed % 2 == 0 ? NormalRule::linear : NormalRule::cofactor;
      needs.out.tangents = seed % 3 != 1;
      SCOPED_TRACE(simd_name(target) + " seed " + std::to_string(seed));
      expect_same_vertices(scene, needs);
    }
  }
}

TEST(combinations_in_frames, N22_give_the_same_bits_where_matrices_leave_normals_no_length) {
  for (const float scale : {0.0f, 1e-17f, 1e17f}) {
    Scene scene = random_scene(7, repeating(7));
    scene.skeleton.rest[0].scale = glm::vec3(scale);
    for (Animation& animation : scene.animations)
      std::erase_if(animation.bones, [](const BoneAnimation& bone) { return bone.joint == 0; });
    finish_scene(scene);
    for (const NormalRule rule : {NormalRule::linear, NormalRule::cofactor}) {
      Needs needs;
      needs.skin.normal_rule = rule;
      SCOPED_TRACE(scale);
      expect_same_vertices(scene, needs);
    }
  }
}

TEST(combinations_in_frames, are_made_once_for_all_instances_of_a_skin_and_only_for_linear_skinning) {
  const Scene scene = random_scene(2, repeating(2));
  const Plan plan = compile_plan(lend(scene), {});
  const CompiledPlan& compiled = *plan.compiled();
  std::size_t of_primitives = 0, tables = 0;
  for (const PrimitiveSkinning& s : compiled.primitive_skinning) of_primitives += s.combined != kNone;
  for (const auto& of_skin : compiled.combined) tables += of_skin.size();
  EXPECT_LT(tables, of_primitives);
  Needs needs;
  needs.skin.kind = Skinning::dual_quaternion;
  EXPECT_FALSE(stage(compile_plan(lend(scene), needs), "combinations").runs);
  const auto palette_bytes = [](const Plan& of) {
    std::size_t matrices = 0;
    for (const Block<JointMatrix>& block : of.compiled()->layout.palettes) matrices += block.count;
    return matrices * sizeof(JointMatrix);
  };
  EXPECT_LT(palette_bytes(compile_plan(lend(scene), needs)), palette_bytes(plan))
      << "no memory for matrices that nobody shares";
}

TEST(combinations_in_frames, the_plan_says_how_many_and_why) {
  const Scene scene = random_scene(2, repeating(2));
  const PlanStage runs = stage(compile_plan(lend(scene), {}), "combinations");
  EXPECT_TRUE(runs.runs);
  EXPECT_EQ(runs.bytes, runs.count * sizeof(JointMatrix));
  EXPECT_NE(runs.reason.find(std::to_string(runs.count) + " combinations of joints and weights for "),
            std::string::npos)
      << runs.reason;
  const PlanStage left_out = stage(compile_plan(random_scene(2), {}), "combinations");
  EXPECT_FALSE(left_out.runs);
  EXPECT_NE(left_out.reason.find("sharing does not pay in 4 primitives: "), std::string::npos) << left_out.reason;
}

TEST(combinations_in_frames, P19_follow_the_palette_through_buffers_that_take_turns_and_allocate_nothing) {
  const Scene scene = random_scene(5, repeating(5));
  const Plan plan = compile_plan(lend(scene), {});
  FrameBuffer buffers[] = {FrameBuffer(plan), FrameBuffer(plan)};
  const double times_s[] = {0.2, 0.2, 0.2, 0.7, 0.7, 0.2, 0.9};
  std::size_t turn = 0;
  for (const double time_s : times_s) {
    FrameBuffer &now = buffers[turn % 2], &before = buffers[(turn + 1) % 2];
    const ClipLayer layer{0, time_s, 1.0f};
    const FrameInput input{.layers = {&layer, 1}, .weights = {}, .root = {}};
    if (turn > 0) {
      now.count_from(before.result().frame);
      now.follow(before);
    }
    const AllocationCounter counter;
    ASSERT_EQ(run_plan(plan, input, now), ErrorCode::ok);
    EXPECT_EQ(counter.count(), 0u);
    FrameBuffer fresh(plan);
    ASSERT_EQ(run_plan(plan, input, fresh), ErrorCode::ok);
    EXPECT_EQ(hash_vertices(now.result()), hash_vertices(fresh.result())) << turn;
    if (turn == 2) {
      EXPECT_EQ(now.result().work.combinations_blended, 0u);
    }
    ++turn;
  }
}

}  // namespace
}  // namespace sinew::test
