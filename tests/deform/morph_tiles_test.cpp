// SPDX-License-Identifier: MIT
#include "runtime/deform/morph_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "runtime/deform/morph_vertices.h"
#include "runtime/deform/skin_tiles.h"
#include "tests/reference/skinning.h"
#include "tests/support/near.h"
#include "tests/support/shared_joints.h"
#include "tests/support/simd_targets.h"
#include "tests/support/skinned_vertices.h"

namespace sinew {
namespace {

constexpr std::uint32_t kCountsOfFace[] = {1, 2, 3, 4, 6};

/// A skinned mesh with morph targets, in both orders.
struct TiledFace {
  test::SkinnedVertices s;
  MorphSet morphs;
  VertexTiles tiles;
  TiledMorphs tiled;
  std::vector<float> weights;
  std::vector<TilePlane> positions, normals, tangents;

  explicit TiledFace(std::uint64_t seed, std::uint32_t group_size = 300, std::uint32_t target_count = 4) {
    test::FixedRandom random(seed);
    s = test::random_skinned_vertices(random, kCountsOfFace, group_size, 24, true);
    test::share_joints(random, s, 3);
    const auto count = static_cast<std::uint32_t>(s.positions.size());
    for (std::uint32_t t = 0; t < target_count; ++t) {
      MorphTarget& target = morphs.targets.emplace_back();
      for (std::uint32_t v = random.below(4); v < count; v += 1 + random.below(5)) {
        target.positions.vertices.push_back(v);
        target.positions.deltas.push_back(random.vec3());
        if (t % 2 == 0) continue;
        target.normals.vertices.push_back(v);
        target.normals.deltas.push_back(random.vec3(-0.3, 0.3));
        target.tangents.vertices.push_back(v);
        target.tangents.deltas.push_back(random.vec3(-0.3, 0.3));
      }
      weights.push_back(static_cast<float>(random.in(-1, 2)));
    }
    tiles = tile_vertices(s.influences, s.in());
    tiled = tile_morphs(morphs, tiles);
    positions.resize(3 * tiles.tile_count());
    normals.resize(3 * tiles.tile_count());
    tangents.resize(4 * tiles.tile_count());
  }
  MorphTilesJob morph() {
    return {.tiles = &tiles, .morphs = &tiled, .weights = weights, .out = {positions, normals, tangents}};
  }
  SkinTilesJob skin() {
    return {.tiles = &tiles, .palette = s.palette, .out = s.out(), .morphed = {positions, normals, tangents}};
  }

  /// eq   attribute + sum(weight * delta), in double
  Vec3<double> truth(glm::vec3 from, SparseDeltas<glm::vec3> MorphTarget::*attribute, std::size_t v) const {
    Vec3<double> sum(from);
    for (std::size_t t = 0; t < morphs.targets.size(); ++t) {
      const SparseDeltas<glm::vec3>& sparse = morphs.targets[t].*attribute;
      const auto at = std::find(sparse.vertices.begin(), sparse.vertices.end(), v);
      if (at != sparse.vertices.end())
        sum += double{weights[t]} * Vec3<double>(sparse.deltas[static_cast<std::size_t>(at - sparse.vertices.begin())]);
    }
    return sum;
  }
};

TEST(morph_tiles, sums_have_the_bits_of_the_job_on_packed_vertices_on_every_instruction_set) {
  for (const std::uint32_t size : {1u, 5u, 300u}) {
    TiledFace face(size, size);
    const std::size_t count = face.s.positions.size();
    std::vector<glm::vec3> positions(count), normals(count), scratch(count);
    std::vector<glm::vec4> tangents(count);
    ASSERT_EQ(run(MorphVerticesJob{.morphs = &face.morphs,
                                   .weights = face.weights,
                                   .vertices = face.s.in(),
                                   .out = {positions, normals, tangents},
                                   .scratch = scratch,
                                   .normalise = false}),
              ErrorCode::ok);
    for (const std::int64_t target : test::simd_targets()) {
      const test::OnlyTarget only(target);
      for (auto* planes : {&face.positions, &face.normals, &face.tangents})
        std::fill(planes->begin(), planes->end(), TilePlane{});
      ASSERT_EQ(run(face.morph()), ErrorCode::ok);
      for (std::size_t lane = 0; lane < face.tiles.vertices.size(); ++lane) {
        const std::size_t v = face.tiles.vertices[lane], tile = lane / VertexTiles::kLanes,
                          i = lane % VertexTiles::kLanes;
        for (int c = 0; c < 4; ++c) {
          const auto plane = static_cast<std::size_t>(c);
          EXPECT_EQ(face.tangents[4 * tile + plane].lane[i], tangents[v][c]) << v;
          if (c == 3) break;
          EXPECT_EQ(face.positions[3 * tile + plane].lane[i], positions[v][c]) << v;
          EXPECT_EQ(face.normals[3 * tile + plane].lane[i], normals[v][c]) << v;
        }
      }
    }
  }
}

TEST(morph_tiles, morphed_and_skinned_vertices_agree_with_double_on_every_instruction_set) {
  for (const std::int64_t target : test::simd_targets()) {
    const test::OnlyTarget only(target);
    TiledFace face(2, 50);
    ASSERT_EQ(run(face.morph()), ErrorCode::ok);
    ASSERT_EQ(run(face.skin()), ErrorCode::ok);
    for (std::size_t v = 0; v < face.s.positions.size(); ++v) {
      std::vector<Affined> matrices;
      std::vector<double> weights;
      for (const auto j : face.s.joints_of(v)) matrices.push_back(affine_cast<double>(affine_from(face.s.palette[j])));
      for (const auto w : face.s.weights_of(v)) weights.push_back(w);
      const Affined m = reference::blend_matrices<double>(matrices, weights);
      const auto p = face.truth(face.s.positions[v], &MorphTarget::positions, v),
                 n = face.truth(face.s.normals[v], &MorphTarget::normals, v),
                 t = face.truth(glm::vec3(face.s.tangents[v]), &MorphTarget::tangents, v);
      EXPECT_TRUE(test::is_near(Vec3<double>(face.s.out_positions[v]), transform_point(m, p), 4e-6)) << v;
      EXPECT_TRUE(test::is_near(Vec3<double>(face.s.out_normals[v]), glm::normalize(transform_vector(m, n)), 4e-5))
          << v;
      EXPECT_TRUE(
          test::is_near(Vec3<double>(glm::vec3(face.s.out_tangents[v])), glm::normalize(transform_vector(m, t)), 4e-5))
          << v;
      EXPECT_EQ(face.s.out_tangents[v].w, face.s.tangents[v].w);
    }
  }
}

TEST(morph_tiles, a_collapsed_matrix_keeps_the_morphed_normal) {
  TiledFace face(3, 20);
  for (auto& m : face.s.palette) m = joint_matrix_from(affine_from(Mat3<float>(0.0f), {1, 2, 3}));
  ASSERT_EQ(run(face.morph()), ErrorCode::ok);
  ASSERT_EQ(run(face.skin()), ErrorCode::ok);
  for (std::size_t v = 0; v < face.s.positions.size(); ++v)
    EXPECT_TRUE(test::is_near(Vec3<double>(face.s.out_normals[v]),
                              face.truth(face.s.normals[v], &MorphTarget::normals, v), 1e-6))
        << v;
}

TEST(morph_tiles, attributes_that_are_not_morphed_are_read_from_the_tiles) {
  TiledFace face(4, 20);
  auto morph = face.morph();
  morph.out.normals = morph.out.tangents = {};
  ASSERT_EQ(run(morph), ErrorCode::ok);
  auto skin = face.skin();
  skin.morphed = {.positions = face.positions, .normals = {}, .tangents = {}};
  ASSERT_EQ(run(skin), ErrorCode::ok);
  const auto normals = face.s.out_normals;
  const auto tangents = face.s.out_tangents;
  skin.morphed = {};
  ASSERT_EQ(run(skin), ErrorCode::ok);
  EXPECT_EQ(face.s.out_normals, normals);
  EXPECT_EQ(face.s.out_tangents, tangents);
}

TEST(morph_tiles, weights_of_zero_leave_the_vertices_of_the_tiles) {
  TiledFace face(5, 20);
  face.weights = {0.0f, -0.0f, 1e-30f, 0.0f};
  ASSERT_EQ(run(face.morph()), ErrorCode::ok);
  for (std::size_t i = 0; i < face.positions.size(); ++i) {
    EXPECT_EQ(face.positions[i].lane, face.tiles.positions[i].lane);
    EXPECT_EQ(face.normals[i].lane, face.tiles.normals[i].lane);
  }
}

TEST(morph_tiles, planes_of_a_few_vertices_take_more_memory_than_their_deltas) {
  TiledFace face(6);
  MorphSet every_vertex, one_in_16;
  every_vertex.targets.resize(1);
  one_in_16.targets.resize(1);
  for (std::uint32_t v = 0; v < face.tiles.vertex_count; ++v) every_vertex.targets[0].positions.vertices.push_back(v);
  for (const TileRun& run : face.tiles.runs)
    for (std::uint32_t lane = 0; lane < run.lane_count; lane += VertexTiles::kLanes)
      one_in_16.targets[0].positions.vertices.push_back(
          face.tiles.vertices[run.first_tile * VertexTiles::kLanes + lane]);
  std::sort(one_in_16.targets[0].positions.vertices.begin(), one_in_16.targets[0].positions.vertices.end());
  for (MorphSet* set : {&every_vertex, &one_in_16})
    set->targets[0].positions.deltas.resize(set->targets[0].positions.vertices.size(), glm::vec3(1));
  EXPECT_NEAR(tile_morphs(every_vertex, face.tiles).relative_memory, 0.8, 0.1);
  EXPECT_EQ(tile_morphs(one_in_16, face.tiles).relative_memory, 12.0);
  EXPECT_EQ(tile_morphs({}, face.tiles).relative_memory, 0.0);
}

TEST(morph_tiles, rejects_what_it_cannot_do) {
  TiledFace face(1, 5);
  EXPECT_EQ(check(face.morph()), ErrorCode::ok);
  auto job = face.morph();
  job.tiles = nullptr;
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = face.morph();
  job.morphs = nullptr;
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = face.morph();
  job.weights = job.weights.first(3);
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  for (const auto attribute : {&TiledOutput::positions, &TiledOutput::normals, &TiledOutput::tangents}) {
    job = face.morph();
    job.out.*attribute = (job.out.*attribute).first((job.out.*attribute).size() - 1);
    EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  }
  const TiledMorphs sound = face.tiled;
  for (const auto attribute : {&TiledTarget::positions, &TiledTarget::normals, &TiledTarget::tangents}) {
    face.tiled = sound;
    (face.tiled.targets[1].*attribute).tiles.back() = static_cast<std::uint32_t>(face.tiles.tile_count());
    EXPECT_EQ(check(face.morph()), ErrorCode::index_out_of_range);
    face.tiled = sound;
    (face.tiled.targets[1].*attribute).planes.pop_back();
    EXPECT_EQ(check(face.morph()), ErrorCode::index_out_of_range);
  }
  face.tiled = sound;
  face.weights[3] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(check(face.morph()), ErrorCode::not_finite);
}

TEST(morph_tiles, skinning_rejects_morphed_attributes_without_all_tiles) {
  TiledFace face(1, 5);
  EXPECT_EQ(check(face.skin()), ErrorCode::ok);
  for (const auto attribute : {&TiledInput::positions, &TiledInput::normals, &TiledInput::tangents}) {
    auto job = face.skin();
    job.morphed.*attribute = (job.morphed.*attribute).first((job.morphed.*attribute).size() - 1);
    EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  }
}

}  // namespace
}  // namespace sinew
