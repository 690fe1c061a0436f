// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstring>
#include <glm/geometric.hpp>
#include <vector>

#include "runtime/deform/skin_tiles.h"
#include "tests/reference/skinning.h"
#include "tests/support/near.h"
#include "tests/support/shared_joints.h"
#include "tests/support/simd_targets.h"
#include "tests/support/skinned_vertices.h"

namespace sinew {
namespace {

constexpr std::uint32_t kTiledCounts[] = {1, 2, 3, 4, 5, 8, 12};

/// Vertices of all influence counts, of which some share joints, and their tiles.
struct TiledVertices {
  test::SkinnedVertices s;
  VertexTiles tiles;

  explicit TiledVertices(std::uint64_t seed, std::uint32_t group_size = 50, bool with_scale = true) {
    test::FixedRandom random(seed);
    s = test::random_skinned_vertices(random, kTiledCounts, group_size, 24, with_scale);
    test::share_joints(random, s, 3);
    tiles = tile_vertices(s.influences, s.in());
  }
  SkinTilesJob job() { return {.tiles = &tiles, .palette = s.palette, .out = s.out()}; }

  /// Double-precision blend of the matrices of vertex v.
  Affined truth(std::size_t v) const {
    std::vector<Affined> matrices;
    std::vector<double> weights;
    for (const auto j : s.joints_of(v)) matrices.push_back(affine_cast<double>(affine_from(s.palette[j])));
    for (const auto w : s.weights_of(v)) weights.push_back(w);
    return reference::blend_matrices<double>(matrices, weights);
  }
  void expect_near_truth(NormalRule rule, double of_directions) const {
    for (std::size_t v = 0; v < s.positions.size(); ++v) {
      const Affined m = truth(v);
      EXPECT_TRUE(
          test::is_near(Vec3<double>(s.out_positions[v]), transform_point(m, Vec3<double>(s.positions[v])), 4e-6))
          << v;
      const Vec3<double> n(s.normals[v]), t{glm::vec3(s.tangents[v])};
      const auto moved = rule == NormalRule::cofactor ? transform_normal_outward(linear_part(m), n)
                                                      : glm::normalize(transform_vector(m, n));
      EXPECT_TRUE(test::is_near(Vec3<double>(s.out_normals[v]), moved, of_directions)) << v;
      EXPECT_TRUE(test::is_near(Vec3<double>(glm::vec3(s.out_tangents[v])), glm::normalize(transform_vector(m, t)),
                                of_directions))
          << v;
      EXPECT_EQ(s.out_tangents[v].w, s.tangents[v].w);
    }
  }
};

/// The bits of all outputs.
struct OutputBits {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec4> tangents;

  explicit OutputBits(const test::SkinnedVertices& s)
      : positions(s.out_positions), normals(s.out_normals), tangents(s.out_tangents) {}
  friend bool operator==(const OutputBits& a, const OutputBits& b) {
    const auto same = [](const auto& x, const auto& y) {
      return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(x[0])) == 0;
    };
    return same(a.positions, b.positions) && same(a.normals, b.normals) && same(a.tangents, b.tangents);
  }
};

TEST(skin_vertex_tiles, rejects_wrong_sizes_and_joints_out_of_range) {
  TiledVertices v(1, 3);
  EXPECT_EQ(check(v.job()), ErrorCode::ok);
  auto job = v.job();
  job.tiles = nullptr;
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = v.job();
  job.palette = job.palette.first(v.tiles.joint_count - 1);
  EXPECT_EQ(check(job), ErrorCode::index_out_of_range);
  job = v.job();
  job.palette = {static_cast<const JointMatrix*>(nullptr), 24};
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = v.job();
  job.out.positions = job.out.positions.first(1);
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = v.job();
  job.out.normals = job.out.normals.first(1);
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = v.job();
  job.out.tangents = job.out.tangents.first(1);
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
}

TEST(skin_vertex_tiles, no_vertices_is_no_work) {
  const VertexTiles none = tile_vertices({}, {});
  EXPECT_EQ(run(SkinTilesJob{.tiles = &none, .palette = {}, .out = {}}), ErrorCode::ok);
}

TEST(skin_vertex_tiles, vertices_agree_with_double_on_every_instruction_set) {
  for (const std::int64_t target : test::simd_targets()) {
    const test::OnlyTarget only(target);
    TiledVertices v(2);
    EXPECT_EQ(run(v.job()), ErrorCode::ok);
    v.expect_near_truth(NormalRule::linear, 2e-5);
  }
}

TEST(skin_vertex_tiles, cofactor_normals_agree_with_double_on_every_instruction_set) {
  for (const std::int64_t target : test::simd_targets()) {
    const test::OnlyTarget only(target);
    TiledVertices v(3);
    auto job = v.job();
    job.normal_rule = NormalRule::cofactor;
    EXPECT_EQ(run(job), ErrorCode::ok);
    v.expect_near_truth(NormalRule::cofactor, 4e-5);
  }
}

TEST(skin_vertex_tiles, groups_of_every_size_have_the_same_bits_on_every_instruction_set) {
  for (const std::uint32_t size : {1u, 3u, 4u, 5u, 9u, 15u, 16u, 17u, 33u, 50u, 200u})
    for (const auto rule : {NormalRule::linear, NormalRule::cofactor}) {
      TiledVertices v(size, size);
      v.s.palette[5] = joint_matrix_from(affine_from(Mat3<float>(0.0f), {1, 2, 3}));  // normals collapse
      v.s.normals[size / 2] = glm::vec3(0);
      const auto bits_on = [&](std::int64_t target) {
        const test::OnlyTarget only(target);
        auto job = v.job();
        job.normal_rule = rule;
        run_unchecked(job);
        return OutputBits(v.s);
      };
      const OutputBits fused = bits_on(test::simd_targets().front()), unfused = bits_on(test::simd_targets().back());
      for (const std::int64_t target : test::simd_targets())
        EXPECT_TRUE(bits_on(target) == (test::fuses_multiply_add(target) ? fused : unfused))
            << size << ' ' << test::simd_name(target);
    }
}

TEST(skin_vertex_tiles, stores_past_the_caches_write_the_same_bits) {
  for (const std::int64_t target : test::simd_targets()) {
    const test::OnlyTarget only(target);
    TiledVertices v(5, 200);
    run_unchecked(v.job());
    const OutputBits cached(v.s);
    struct alignas(64) Line {
      float of[16];
    };
    const std::size_t count = v.s.positions.size();
    for (const std::size_t off : {0, 1}) {
      std::vector<Line> memory((count * 10 + 64) / 16 + 4);
      float* at = memory[0].of;
      const std::size_t normals = (count * 3 + 15) / 16 * 16, tangents = 2 * normals;
      v.s.out_positions.assign(count, glm::vec3(0));
      auto job = v.job();
      job.past_caches = true;
      job.out = {{reinterpret_cast<glm::vec3*>(at), count},
                 {reinterpret_cast<glm::vec3*>(at + normals + off * 3), count},
                 {reinterpret_cast<glm::vec4*>(at + tangents + 16), count}};
      run_unchecked(job);
      v.s.out_positions.assign(job.out.positions.begin(), job.out.positions.end());
      v.s.out_normals.assign(job.out.normals.begin(), job.out.normals.end());
      v.s.out_tangents.assign(job.out.tangents.begin(), job.out.tangents.end());
      EXPECT_TRUE(cached == OutputBits(v.s)) << test::simd_name(target) << ' ' << off;
    }
  }
}

TEST(skin_vertex_tiles, a_collapsed_matrix_keeps_the_normal) {
  for (const auto rule : {NormalRule::linear, NormalRule::cofactor}) {
    TiledVertices v(6, 20);
    for (auto& m : v.s.palette) m = joint_matrix_from(affine_from(Mat3<float>(0.0f), {1, 2, 3}));
    auto job = v.job();
    job.normal_rule = rule;
    EXPECT_EQ(run(job), ErrorCode::ok);
    EXPECT_EQ(v.s.out_normals, v.s.normals);
    EXPECT_EQ(v.s.out_tangents, v.s.tangents);
  }
}

TEST(skin_vertex_tiles, the_bind_pose_moves_nothing_by_a_bit) {
  TiledVertices v(7, 20);
  for (auto& m : v.s.palette) m = {};
  EXPECT_EQ(run(v.job()), ErrorCode::ok);
  EXPECT_EQ(v.s.out_positions, v.s.positions);
}

TEST(skin_vertex_tiles, attributes_that_are_not_wanted_are_not_written) {
  TiledVertices all(8), v(8);
  EXPECT_EQ(run(all.job()), ErrorCode::ok);
  for (const bool tangents : {false, true}) {
    auto job = v.job();
    job.out.normals = {};
    if (!tangents) job.out.tangents = {};
    EXPECT_EQ(run(job), ErrorCode::ok);
    EXPECT_EQ(v.s.out_positions, all.s.out_positions);
    EXPECT_EQ(v.s.out_normals, std::vector<glm::vec3>(v.s.normals.size()));
    EXPECT_EQ(v.s.out_tangents, tangents ? all.s.out_tangents : std::vector<glm::vec4>(v.s.tangents.size()));
  }
}

TEST(skin_vertex_tiles, nothing_is_written_beyond_the_vertices) {
  for (const std::uint32_t size : {1u, 5u, 19u}) {
    TiledVertices v(9, size);
    const std::size_t count = v.s.positions.size();
    v.s.out_positions.assign(count + 16, glm::vec3(77));
    v.s.out_normals.assign(count + 16, glm::vec3(77));
    v.s.out_tangents.assign(count + 16, glm::vec4(77));
    run_unchecked(v.job());
    for (std::size_t i = count; i < count + 16; ++i) {
      EXPECT_EQ(v.s.out_positions[i], glm::vec3(77));
      EXPECT_EQ(v.s.out_normals[i], glm::vec3(77));
      EXPECT_EQ(v.s.out_tangents[i], glm::vec4(77));
    }
  }
}

/// Where two primitives meet, their vertices are equal. In one of them they take lanes beside vertices of more joints.
TEST(skin_vertex_tiles, equal_vertices_of_two_meshes_have_equal_bits) {
  test::FixedRandom random(11);
  test::SkinnedVertices seam, body;
  seam.influences.groups = {{0, 5, 2, 0}};
  for (int v = 0; v < 5; ++v) {
    const auto weight = static_cast<float>(random.in(0.02, 0.98));
    seam.influences.joints.insert(seam.influences.joints.end(), {6, 2});
    seam.influences.weights.insert(seam.influences.weights.end(), {weight, 1.0f - weight});
    seam.positions.push_back(random.vec3());
  }
  body = seam;
  body.influences.groups.push_back({5, 3, 3, 10});
  for (int v = 0; v < 3; ++v) {
    body.influences.joints.insert(body.influences.joints.end(), {9, 6, 2});
    body.influences.weights.insert(body.influences.weights.end(), {0.9f, 0.05f, 0.05f});
    body.positions.push_back(random.vec3());
  }
  seam.out_positions.resize(5);
  body.out_positions.resize(8);
  std::vector<JointMatrix> palette;
  for (int j = 0; j < 10; ++j) palette.push_back(joint_matrix_from(affine_from_transform(random.transform())));
  const VertexTiles of_seam = tile_vertices(seam.influences, seam.in()),
                    of_body = tile_vertices(body.influences, body.in());
  ASSERT_EQ(of_body.runs.size(), 1u) << "the seam fills up the run of three joints";
  for (const std::int64_t target : test::simd_targets()) {
    const test::OnlyTarget only(target);
    EXPECT_EQ(run(SkinTilesJob{.tiles = &of_seam, .palette = palette, .out = seam.out()}), ErrorCode::ok);
    EXPECT_EQ(run(SkinTilesJob{.tiles = &of_body, .palette = palette, .out = body.out()}), ErrorCode::ok);
    body.out_positions.resize(5);
    EXPECT_EQ(seam.out_positions, body.out_positions) << test::simd_name(target);
    body.out_positions.resize(8);
  }
}

/// Vertices of joint 1 alone take lanes beside those that also follow joint 4.
TEST(skin_vertex_tiles, a_joint_far_away_does_not_reach_the_vertices_that_do_not_follow_it) {
  test::SkinnedVertices s;
  test::FixedRandom random(10);
  s.influences = {{{0, 3, 1, 0}, {3, 5, 2, 3}}, {1, 1, 1, 1, 4, 1, 4, 1, 4, 1, 4, 1, 4}, {1, 1, 1}};
  for (int i = 0; i < 5; ++i) s.influences.weights.insert(s.influences.weights.end(), {0.75f, 0.25f});
  for (int i = 0; i < 8; ++i) s.positions.push_back(random.vec3());
  s.out_positions.resize(8);
  s.palette.resize(5);
  s.palette[1] = joint_matrix_from(affine_from_transform(random.transform()));
  s.palette[4].column[3] = {1e7f, 0, 0, 1};
  const VertexTiles tiles = tile_vertices(s.influences, s.in());
  ASSERT_EQ(tiles.runs.size(), 1u);
  EXPECT_EQ(run(SkinTilesJob{.tiles = &tiles, .palette = s.palette, .out = s.out()}), ErrorCode::ok);
  const Affine m = affine_from(s.palette[1]);
  for (std::size_t v = 0; v < 3; ++v)
    EXPECT_TRUE(test::is_near(s.out_positions[v], transform_point(m, s.positions[v]), 1e-6)) << v;
}

}  // namespace
}  // namespace sinew
