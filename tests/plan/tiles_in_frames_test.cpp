// SPDX-License-Identifier: MIT
// Plans sort the vertices of meshes that are skinned linearly into tiles, where that is faster.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "runtime/plan/frame_hash.h"
#include "runtime/plan/run_plan.h"
#include "tests/plan/changed_plan.h"
#include "tests/plan/plan_dump.h"
#include "tests/scenes/random_scene.h"
#include "tests/scenes/skeletons.h"
#include "tests/scenes/skinned_surface.h"
#include "tests/scenes/stretches.h"
#include "tests/scenes/swinging.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/near.h"
#include "tests/support/simd_targets.h"

namespace sinew::test {
namespace {

/// A scene whose meshes all win by tiles.
Scene tiled_scene(std::uint64_t seed, RandomSceneOptions options = {}) {
  options.targets = 0;
  options.triangles = 200;
  Scene scene = random_scene(seed, options);
  share_joints_in_stretches(scene, 32);
  return scene;
}

std::size_t tiled_primitives(const Plan& plan) {
  const auto& all = plan.compiled()->primitive_skinning;
  return static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(), [](const PrimitiveSkinning& s) { return s.tiles != nullptr; }));
}

std::size_t skinned_primitives(const Plan& plan) {
  const auto all = plan.primitives();
  return static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(), [](const PrimitivePlan& p) { return p.skin.any(); }));
}

TEST(tiles_in_frames, are_made_once_for_all_instances_and_skins_of_a_mesh) {
  RandomSceneOptions options;
  options.instances = 12;
  const Scene scene = tiled_scene(3, options);
  const Plan plan = compile_plan(lend(scene), {});
  ASSERT_EQ(tiled_primitives(plan), skinned_primitives(plan));
  std::set<const VertexTiles*> tables;
  std::set<const Primitive*> shown;
  for (std::size_t p = 0; p < plan.primitives().size(); ++p)
    if (const VertexTiles* tiles = plan.compiled()->primitive_skinning[p].tiles.get(); tiles != nullptr) {
      tables.insert(tiles);
      shown.insert(&primitive_of(plan, plan.primitives()[p]));
    }
  EXPECT_EQ(tables.size(), shown.size());
  EXPECT_LT(tables.size(), tiled_primitives(plan));
}

TEST(tiles_in_frames, are_those_of_the_plan_beside_where_they_have_what_is_needed) {
  RandomSceneOptions options;
  options.flat_normals = true;
  const Scene scene = tiled_scene(3, options);
  Needs of_far_ones;
  of_far_ones.out.tangents = false;
  const Plan near_plan = compile_plan(lend(scene), {});
  const Plan far_plan = compile_plan(lend(scene), of_far_ones, near_plan);
  const CompiledPlan &near_ones = *near_plan.compiled(), &far_ones = *far_plan.compiled();
  ASSERT_GT(tiled_primitives(far_plan), 0u);
  for (std::size_t p = 0; p < near_ones.primitives.size(); ++p) {
    EXPECT_EQ(near_ones.primitive_skinning[p].tiles, far_ones.primitive_skinning[p].tiles) << p;
    EXPECT_EQ(near_ones.flat_faces[p], far_ones.flat_faces[p]) << p;
  }
  const Plan lone_plan = compile_plan(lend(scene), of_far_ones);
  FrameBuffer shared(far_plan), alone(lone_plan);
  ASSERT_EQ(run_plan(far_plan, {}, shared), ErrorCode::ok);
  ASSERT_EQ(run_plan(lone_plan, {}, alone), ErrorCode::ok);
  EXPECT_EQ(hash_vertices(shared.result()), hash_vertices(alone.result()));
}

TEST(tiles_in_frames, are_made_anew_beside_a_plan_whose_tiles_lack_an_attribute) {
  const Scene scene = tiled_scene(3);
  Needs fewer;
  fewer.out.normals = false;
  const Plan beside = compile_plan(lend(scene), fewer), plan = compile_plan(lend(scene), {}, beside);
  ASSERT_GT(tiled_primitives(plan), 0u);
  for (std::size_t p = 0; p < plan.primitives().size(); ++p)
    if (const VertexTiles* tiles = plan.compiled()->primitive_skinning[p].tiles.get(); tiles != nullptr) {
      EXPECT_NE(tiles, beside.compiled()->primitive_skinning[p].tiles.get());
      EXPECT_FALSE(tiles->normals.empty());
    }
}

TEST(tiles_in_frames, hold_the_attributes_that_the_needs_ask_for) {
  const Scene scene = tiled_scene(3);
  for (const bool normals : {false, true})
    for (const bool tangents : {false, true}) {
      Needs needs;
      needs.out.normals = normals;
      needs.out.tangents = tangents;
      const Plan plan = compile_plan(lend(scene), needs);
      ASSERT_GT(tiled_primitives(plan), 0u);
      for (std::size_t p = 0; p < plan.primitives().size(); ++p)
        if (const VertexTiles* tiles = plan.compiled()->primitive_skinning[p].tiles.get(); tiles != nullptr) {
          EXPECT_EQ(tiles->normals.empty(), !plan.primitives()[p].skin.normals);
          EXPECT_EQ(tiles->tangents.empty(), !plan.primitives()[p].skin.tangents);
        }
    }
}

TEST(tiles_in_frames, the_plan_says_how_many_and_frames_count_their_vertices) {
  const Scene scene = tiled_scene(3);
  const Plan plan = compile_plan(lend(scene), {});
  const PlanStage skin = stage(plan, "skin_linear");
  EXPECT_NE(skin.reason.find("; vertices of " + std::to_string(tiled_primitives(plan)) + " sorted by joints"),
            std::string::npos)
      << skin.reason;
  FrameBuffer frame(plan);
  ASSERT_EQ(run_plan(plan, {}, frame), ErrorCode::ok);
  EXPECT_EQ(frame.result().work.vertices_skinned_linear, skin.count);
  EXPECT_EQ(frame.result().work.vertices_skinned_in_tiles, skin.count);
}

TEST(tiles_in_frames, serve_dual_quaternions_too_and_are_shared_with_linear_skinning) {
  const Scene scene = tiled_scene(3);
  Needs needs;
  needs.skin.kind = Skinning::dual_quaternion;
  const Plan linear = compile_plan(lend(scene), {}), rigid = compile_plan(lend(scene), needs, linear);
  ASSERT_GT(tiled_primitives(rigid), 0u);
  for (std::size_t p = 0; p < rigid.primitives().size(); ++p) {
    const PrimitiveSkinning &of_linear = linear.compiled()->primitive_skinning[p],
                            &of_rigid = rigid.compiled()->primitive_skinning[p];
    if (of_linear.combined != kNone) continue;
    EXPECT_EQ(of_rigid.tiles, of_linear.tiles) << p;
  }
  EXPECT_NE(stage(rigid, "skin_dual_quaternion").reason.find("sorted by joints"), std::string::npos);
}

TEST(tiles_in_frames, are_left_out_where_vertices_share_no_joints) {
  EXPECT_EQ(tiled_primitives(compile_plan(random_scene(3), {})), 0u);
  const Plan plan = compile_plan(random_scene(3), {});
  FrameBuffer frame(plan);
  ASSERT_EQ(run_plan(plan, {}, frame), ErrorCode::ok);
  EXPECT_EQ(frame.result().work.vertices_skinned_in_tiles, 0u);
  EXPECT_EQ(stage(plan, "skin_linear").reason.find("sorted"), std::string::npos);
}

/// Copies of `distinct` vertices of two joints each, all neighbours in the mesh.
Scene copies_of_vertices(std::uint32_t distinct, std::uint32_t copies) {
  const Skeleton skeleton = scenes::long_chain(12);
  Scene scene = scenes::swinging_surface(skeleton, scenes::swinging(skeleton, 20), distinct * copies, 2);
  Primitive& surface = scene.meshes[0].primitives[0];
  for (std::uint32_t v = 0; v < distinct * copies; ++v) {
    const std::uint32_t vertex = v / copies, joint = vertex % 11;
    const float weight = 0.9f - 0.01f * static_cast<float>(vertex / 11);
    surface.influences.joints[2 * v] = static_cast<std::uint16_t>(joint);
    surface.influences.joints[2 * v + 1] = static_cast<std::uint16_t>(joint + 1);
    surface.influences.weights[2 * v] = weight;
    surface.influences.weights[2 * v + 1] = 1.0f - weight;
  }
  return scene;
}

TEST(tiles_in_frames, C06_follow_combined_matrices_where_these_need_no_more_vectors) {
  const Scene many_copies = copies_of_vertices(11, 64);
  const Plan both = compile_plan(lend(many_copies), {});
  EXPECT_EQ(tiled_primitives(both), 1u);
  EXPECT_TRUE(stage(both, "combinations").runs);
  EXPECT_EQ(both.compiled()->primitive_skinning[0].tiles->runs.size(), 11u);
  EXPECT_EQ(both.compiled()->primitive_skinning[0].tiles->runs[0].joint_count, 1u);

  const Scene few_copies = copies_of_vertices(88, 8);  // eight combinations of each pair of joints
  const Plan tiles_alone = compile_plan(lend(few_copies), {});
  EXPECT_EQ(tiled_primitives(tiles_alone), 1u);
  EXPECT_FALSE(stage(tiles_alone, "combinations").runs);
  EXPECT_EQ(matrix_count(*tiles_alone.compiled(), 0), 12u) << "no room for matrices that no frame makes";
  EXPECT_EQ(tiles_alone.compiled()->primitive_skinning[0].tiles->runs[0].joint_count, 2u);
}

TEST(tiles_in_frames, C06_of_combined_matrices_have_the_bits_of_vertices_that_blend_for_themselves) {
  const Scene scene = copies_of_vertices(11, 64);
  const Plan tiled = compile_plan(lend(scene), {}), plain = without_combinations(tiled);
  ASSERT_EQ(tiled_primitives(plain), 0u);
  for (const std::int64_t target : simd_targets()) {
    const OnlyTarget only(target);
    FrameBuffer with(tiled), without(plain);
    const ClipLayer layer{0, 0.3, 1.0f};
    const FrameInput input{.layers = {&layer, 1}, .weights = {}, .root = {}};
    ASSERT_EQ(run_plan(tiled, input, with), ErrorCode::ok);
    ASSERT_EQ(run_plan(plain, input, without), ErrorCode::ok);
    EXPECT_EQ(hash_vertices(with.result()), hash_vertices(without.result())) << simd_name(target);
  }
}

template <class V>
void expect_near(std::span<const V> a, std::span<const V> b, float tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t v = 0; v < a.size(); ++v)
    EXPECT_LE(glm::distance(glm::vec3(a[v]), glm::vec3(b[v])), tolerance * (1.0f + glm::length(glm::vec3(a[v])))) << v;
}

struct Variant {
  NormalRule rule;
  bool flat, mirrored, uneven_root;
};

TEST(tiles_in_frames, show_the_vertices_that_a_skin_without_tiles_shows) {
  for (const Variant& variant :
       {Variant{NormalRule::linear, false, false, false}, Variant{NormalRule::linear, true, true, true},
        Variant{NormalRule::cofactor, false, true, true}, Variant{NormalRule::cofactor, true, false, true}}) {
    RandomSceneOptions options;
    options.flat_normals = variant.flat;
    options.mirrored_joints = variant.mirrored;
    const Scene scene = tiled_scene(4, options);
    Needs needs;
    needs.skin.normal_rule = variant.rule;
    needs.out.bounds = true;
    const Plan tiled = compile_plan(lend(scene), needs), plain = without_tiles(tiled);
    ASSERT_GT(tiled_primitives(tiled), 0u);
    FrameBuffer with(tiled), without(plain);
    const ClipLayer layer{0, 0.4, 1.0f};
    FrameInput input{.layers = {&layer, 1}, .weights = {}, .root = {}};
    if (variant.uneven_root) input.root.row[1].y = 1.5f;
    ASSERT_EQ(run_plan(tiled, input, with), ErrorCode::ok);
    ASSERT_EQ(run_plan(plain, input, without), ErrorCode::ok);
    EXPECT_EQ(with.result().work.normals_by_cofactors, without.result().work.normals_by_cofactors);
    EXPECT_EQ(with.result().work.flat_triangles, without.result().work.flat_triangles);
    for (std::size_t p = 0; p < with.result().primitives.size(); ++p) {
      const DeformedPrimitive &a = with.result().primitives[p], &b = without.result().primitives[p];
      expect_near(a.positions, b.positions, 2e-6f);
      expect_near(a.normals, b.normals, 1e-4f);
      expect_near(a.tangents, b.tangents, 4e-5f);
    }
  }
}

/// A scene whose meshes all win by tiles and have morph targets.
Scene morphed_scene(std::uint64_t seed, RandomSceneOptions options = {}) {
  options.triangles = 200;
  Scene scene = random_scene(seed, options);
  share_joints_in_stretches(scene, 32);
  return scene;
}

/// Moves every 64th vertex only, so that planes of tiles would take much more memory than the deltas.
void scatter_deltas(Scene& scene) {
  for (Mesh& mesh : scene.meshes)
    for (Primitive& primitive : mesh.primitives)
      for (MorphTarget& target : primitive.morphs.targets) {
        SparseDeltas<glm::vec3> few;
        for (std::uint32_t v = 0; v < primitive.vertex_count(); v += 64) {
          few.vertices.push_back(v);
          few.deltas.push_back(glm::vec3(0.5f));
        }
        target.positions = target.normals = target.tangents = few;
      }
}

TEST(tiles_in_frames, of_morphed_meshes_show_the_vertices_that_a_skin_without_tiles_shows) {
  for (const bool flat : {false, true}) {
    RandomSceneOptions options;
    options.flat_normals = flat;
    const Scene scene = morphed_scene(4, options);
    const Plan tiled = compile_plan(lend(scene), {}), plain = without_tiles(tiled);
    ASSERT_EQ(tiled_primitives(tiled), skinned_primitives(tiled));
    FrameBuffer with(tiled), without(plain), past(tiled);
    past.write_past_caches(true);
    for (const double time_s : {0.1, 0.7, 1.3}) {
      const ClipLayer layer{0, time_s, 1.0f};
      const FrameInput input{.layers = {&layer, 1}, .weights = {}, .root = {}};
      const AllocationCounter counter;
      ASSERT_EQ(run_plan(tiled, input, with), ErrorCode::ok);
      EXPECT_EQ(counter.count(), 0u);
      ASSERT_EQ(run_plan(plain, input, without), ErrorCode::ok);
      ASSERT_EQ(run_plan(tiled, input, past), ErrorCode::ok);
      EXPECT_EQ(hash_vertices(with.result()), hash_vertices(past.result()));
      EXPECT_GT(with.result().work.morph_deltas, 0u);
      EXPECT_EQ(with.result().work.vertices_morphed, without.result().work.vertices_morphed);
      EXPECT_EQ(with.result().work.vertices_skinned_in_tiles, with.result().work.vertices_skinned_linear);
      for (std::size_t p = 0; p < with.result().primitives.size(); ++p) {
        const DeformedPrimitive &a = with.result().primitives[p], &b = without.result().primitives[p];
        expect_near(a.positions, b.positions, 4e-6f);
        expect_near(a.normals, b.normals, 2e-4f);
        expect_near(a.tangents, b.tangents, 2e-4f);
      }
    }
  }
}

TEST(tiles_in_frames, with_morph_weights_of_zero_show_the_mesh_that_is_not_morphed) {
  const Scene scene = morphed_scene(4);
  Scene still = scene;
  for (Mesh& mesh : still.meshes)
    for (Primitive& primitive : mesh.primitives)
      for (MorphTarget& target : primitive.morphs.targets) target = {};
  const Plan morphed = compile_plan(lend(scene), {}), plain = compile_plan(lend(still), {});
  const std::vector<float> weights(scene.weight_count(), 0.0f);
  FrameBuffer a(morphed), b(plain);
  ASSERT_EQ(run_plan(morphed, {.layers = {}, .weights = weights, .root = {}}, a), ErrorCode::ok);
  ASSERT_EQ(run_plan(plain, {.layers = {}, .weights = weights, .root = {}}, b), ErrorCode::ok);
  EXPECT_EQ(a.result().work.vertices_morphed, 0u);
  for (std::size_t p = 0; p < morphed.primitives().size(); ++p) {
    if (morphed.compiled()->primitive_skinning[p].tiles == nullptr) continue;
    const DeformedPrimitive &of_morphed = a.result().primitives[p], &of_plain = b.result().primitives[p];
    EXPECT_TRUE(std::ranges::equal(of_morphed.positions, of_plain.positions)) << p;
    EXPECT_TRUE(std::ranges::equal(of_morphed.normals, of_plain.normals)) << p;
    EXPECT_TRUE(std::ranges::equal(of_morphed.tangents, of_plain.tangents)) << p;
  }
}

TEST(tiles_in_frames, of_morphed_meshes_are_those_of_the_plan_beside_if_it_morphs_too) {
  const Scene scene = morphed_scene(4);
  Needs fewer;
  fewer.out.tangents = false;
  const Plan beside = compile_plan(lend(scene), {}), plan = compile_plan(lend(scene), fewer, beside);
  ASSERT_GT(tiled_primitives(plan), 0u);
  for (std::size_t p = 0; p < plan.primitives().size(); ++p) {
    EXPECT_EQ(plan.compiled()->primitive_skinning[p].tiles, beside.compiled()->primitive_skinning[p].tiles) << p;
    EXPECT_EQ(plan.compiled()->primitive_skinning[p].morphs, beside.compiled()->primitive_skinning[p].morphs) << p;
  }
}

TEST(tiles_in_frames, are_left_out_where_planes_of_targets_take_much_memory_and_for_other_skinning_of_morphs) {
  Scene scene = morphed_scene(4);
  Needs rigid;
  rigid.skin.kind = Skinning::dual_quaternion;
  EXPECT_EQ(tiled_primitives(compile_plan(lend(scene), rigid)), 0u);
  ASSERT_GT(tiled_primitives(compile_plan(lend(scene), {})), 0u);
  scatter_deltas(scene);
  EXPECT_EQ(tiled_primitives(compile_plan(lend(scene), {})), 0u);
}

TEST(tiles_in_frames, P19_allocate_nothing_and_write_the_same_bits_past_the_caches) {
  const Scene scene = tiled_scene(5);
  const Plan plan = compile_plan(lend(scene), {});
  FrameBuffer frame(plan), past(plan);
  past.write_past_caches(true);
  const ClipLayer layer{0, 0.4, 1.0f};
  const FrameInput input{.layers = {&layer, 1}, .weights = {}, .root = {}};
  const AllocationCounter counter;
  ASSERT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
  EXPECT_EQ(counter.count(), 0u);
  ASSERT_EQ(run_plan(plan, input, past), ErrorCode::ok);
  EXPECT_EQ(hash_vertices(frame.result()), hash_vertices(past.result()));
}

}  // namespace
}  // namespace sinew::test
