// SPDX-License-Identifier: MIT
#include "runtime/deform/morph_vertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <vector>

#include "runtime/deform/sparse_range.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"
#include "tests/support/simd_targets.h"

namespace sinew {
namespace {

struct Face {
  std::vector<glm::vec3> positions, normals, out_positions, out_normals, scratch;
  std::vector<glm::vec4> tangents, out_tangents;
  MorphSet morphs;
  std::vector<float> weights;

  explicit Face(std::size_t count) : positions(count), normals(count, {0, 0, 1}), tangents(count, {1, 0, 0, -1}) {
    out_positions.resize(count);
    out_normals.resize(count);
    out_tangents.resize(count);
    scratch.resize(count);
  }
  MorphVerticesJob job() {
    return {.morphs = &morphs,
            .weights = weights,
            .vertices = {positions, normals, tangents},
            .out = {out_positions, out_normals, out_tangents},
            .scratch = scratch};
  }
};

Face random_face(test::FixedRandom& random, std::uint32_t count, std::uint32_t targets) {
  Face face(count);
  for (auto& p : face.positions) p = random.vec3(-2, 2);
  for (auto& n : face.normals) n = random.direction();
  for (std::uint32_t t = 0; t < targets; ++t) {
    MorphTarget target;
    for (std::uint32_t v = random.below(4); v < count; v += 1 + random.below(5)) {
      target.positions.vertices.push_back(v);
      target.positions.deltas.push_back(random.vec3());
      target.normals.vertices.push_back(v);
      target.normals.deltas.push_back(random.vec3(-0.3, 0.3));
    }
    face.morphs.targets.push_back(std::move(target));
    face.weights.push_back(static_cast<float>(random.in(-1, 2)));
  }
  return face;
}

TEST(morph_vertices, rejects_what_it_cannot_do) {
  test::FixedRandom random(1);
  Face face = random_face(random, 20, 2);
  EXPECT_EQ(check(face.job()), ErrorCode::ok);
  auto job = face.job();
  job.morphs = nullptr;
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = face.job();
  job.weights = job.weights.first(1);
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = face.job();
  job.scratch = job.scratch.first(19);
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = face.job();
  job.out.positions = job.out.positions.first(19);
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  face.weights[1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(check(face.job()), ErrorCode::not_finite);
  face.weights[1] = 1;
  for (std::size_t t = 0; t < face.morphs.targets.size(); ++t)
    for (const auto attribute : {&MorphTarget::positions, &MorphTarget::normals, &MorphTarget::tangents}) {
      Face wrong = face;
      SparseDeltas<glm::vec3>& sparse = wrong.morphs.targets[t].*attribute;
      sparse = {{20}, {glm::vec3(1)}};
      EXPECT_EQ(check(wrong.job()), ErrorCode::index_out_of_range) << t;
      sparse = {{19}, {}};
      EXPECT_EQ(check(wrong.job()), ErrorCode::index_out_of_range) << t;
      sparse = {{19}, {glm::vec3(1)}};
      EXPECT_EQ(check(wrong.job()), ErrorCode::ok) << t;
    }
}

TEST(morph_vertices, G42_adds_weighted_displacements_also_below_zero_and_above_one) {
  Face face(3);
  face.positions = {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  face.morphs.targets.resize(2);
  face.morphs.targets[0].positions = {{1, 2}, {{0, 1, 0}, {0, 2, 0}}};
  face.morphs.targets[1].positions = {{2}, {{10, 0, 0}}};
  face.weights = {-0.5f, 1.5f};
  EXPECT_EQ(run(face.job()), ErrorCode::ok);
  EXPECT_EQ(face.out_positions[0], glm::vec3(1, 0, 0));
  EXPECT_EQ(face.out_positions[1], glm::vec3(2, -0.5f, 0));
  EXPECT_EQ(face.out_positions[2], glm::vec3(18, -1, 0));
}

TEST(morph_vertices, zero_weights_change_no_bit) {
  test::FixedRandom random(2);
  Face face = random_face(random, 50, 3);
  face.weights = {0.0f, -0.0f, 1e-30f};
  EXPECT_EQ(run(face.job()), ErrorCode::ok);
  EXPECT_TRUE(face.out_positions == face.positions);
  EXPECT_TRUE(face.out_normals == face.normals);
  EXPECT_TRUE(face.out_tangents == face.tangents);
}

TEST(morph_vertices, G45_normals_are_unit_afterwards_and_the_handedness_stays) {
  Face face(1);
  face.morphs.targets.resize(1);
  face.morphs.targets[0].normals = {{0}, {{3, 0, 0}}};
  face.morphs.targets[0].tangents = {{0}, {{0, 0, 2}}};
  face.weights = {1};
  EXPECT_EQ(run(face.job()), ErrorCode::ok);
  EXPECT_TRUE(test::is_near(face.out_normals[0], glm::normalize(glm::vec3(3, 0, 1)), 1e-7));
  EXPECT_TRUE(test::is_near(glm::vec3(face.out_tangents[0]), glm::normalize(glm::vec3(1, 0, 2)), 1e-7));
  EXPECT_EQ(face.out_tangents[0].w, -1.0f);
  auto before_skin = face.job();
  before_skin.normalise = false;
  EXPECT_EQ(run(before_skin), ErrorCode::ok);
  EXPECT_EQ(face.out_normals[0], glm::vec3(3, 0, 1));
}

TEST(morph_vertices, G45_a_normal_that_cancels_keeps_its_base) {
  Face face(1);
  face.morphs.targets.resize(1);
  face.morphs.targets[0].normals = {{0}, {{0, 0, -1}}};
  face.weights = {1};
  EXPECT_EQ(run(face.job()), ErrorCode::ok);
  EXPECT_EQ(face.out_normals[0], glm::vec3(0, 0, 1));
}

TEST(morph_vertices, G45_directions_of_any_length_have_the_components_of_their_unit) {
  constexpr float kLengths[] = {1e-30f, 1e-22f, 1.0f, 1e20f, 1e30f};
  Face face(std::size(kLengths));
  face.morphs.targets.resize(1);
  const glm::vec3 way(0.36f, -0.48f, 0.8f);
  for (std::uint32_t v = 0; v < std::size(kLengths); ++v) {
    face.normals[v] = glm::vec3(0.0f);
    face.morphs.targets[0].normals.vertices.push_back(v);
    face.morphs.targets[0].normals.deltas.push_back(kLengths[v] * way);
  }
  face.weights = {1};
  EXPECT_EQ(run(face.job()), ErrorCode::ok);
  for (std::size_t v = 0; v < std::size(kLengths); ++v)
    EXPECT_TRUE(test::is_near(face.out_normals[v], way, 1e-6)) << kLengths[v];
}

TEST(morph_vertices, random_faces_agree_with_double) {
  test::FixedRandom random(4);
  Face face = random_face(random, 200, 12);
  std::vector<glm::dvec3> truth(face.positions.begin(), face.positions.end()), terms(truth.size(), glm::dvec3(0));
  for (std::size_t t = 0; t < face.weights.size(); ++t) {
    const auto& sparse = face.morphs.targets[t].positions;
    for (std::size_t i = 0; i < sparse.vertices.size(); ++i) {
      const glm::dvec3 term = static_cast<double>(face.weights[t]) * glm::dvec3(sparse.deltas[i]);
      truth[sparse.vertices[i]] += term;
      terms[sparse.vertices[i]] += glm::abs(term);
    }
  }
  EXPECT_EQ(run(face.job()), ErrorCode::ok);
  for (std::size_t v = 0; v < truth.size(); ++v)
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(static_cast<double>(face.out_positions[v][c]), truth[v][c],
                  14 * test::kEps * (terms[v][c] + std::abs(truth[v][c])));
}

TEST(morph_vertices, hundreds_of_small_displacements_on_a_far_base_keep_their_digits) {
  Face face(1);
  face.positions[0] = {1000, 0, 0};
  face.morphs.targets.resize(400);
  for (auto& target : face.morphs.targets) target.positions = {{0}, {{1e-5f, 0, 0}}};
  face.weights.assign(400, 1.0f);
  EXPECT_EQ(run(face.job()), ErrorCode::ok);
  // adding them to the base one by one would lose each of them: half an ulp of 1000 is 3e-5
  EXPECT_NEAR(face.out_positions[0].x, 1000.004f, 6.2e-5f);
}

/// Displacements in runs of random length with random gaps between them.
SparseDeltas<glm::vec3> runs_and_gaps(test::FixedRandom& random, std::uint32_t count) {
  SparseDeltas<glm::vec3> sparse;
  for (std::uint32_t v = random.below(40); v < count; v += random.below(40))
    for (std::uint32_t end = std::min(count, v + 1 + random.below(90)); v < end; ++v) {
      sparse.vertices.push_back(v);
      sparse.deltas.push_back(random.vec3(-0.3, 0.3));
    }
  return sparse;
}

TEST(morph_vertices, long_lists_of_runs_and_gaps_have_the_bits_of_the_plain_sum_on_every_instruction_set) {
  test::FixedRandom random(9);
  for (const std::uint32_t count : {1u, 15u, 16u, 17u, 1023u, 1024u, 1025u, 3100u}) {
    Face face(count);
    std::vector<glm::vec3> expected(count, glm::vec3(0)), turned(count, glm::vec3(0));
    for (int t = 0; t < 7; ++t) {
      MorphTarget target{
          runs_and_gaps(random, count), runs_and_gaps(random, count), runs_and_gaps(random, count), {}, {}};
      const auto weight = static_cast<float>(random.in(-1, 1));
      for (std::size_t i = 0; i < target.positions.vertices.size(); ++i)
        expected[target.positions.vertices[i]] += weight * target.positions.deltas[i];
      for (std::size_t i = 0; i < target.tangents.vertices.size(); ++i)
        turned[target.tangents.vertices[i]] += weight * target.tangents.deltas[i];
      face.morphs.targets.push_back(std::move(target));
      face.weights.push_back(weight);
    }
    for (std::uint32_t v = 0; v < count; ++v) {
      face.positions[v] = random.vec3();
      expected[v] = face.positions[v] + expected[v];
    }
    std::vector<glm::vec3> normals;
    for (const std::int64_t target : test::simd_targets()) {
      const test::OnlyTarget only(target);
      EXPECT_EQ(run(face.job()), ErrorCode::ok);
      EXPECT_TRUE(face.out_positions == expected) << count;
      for (std::uint32_t v = 0; v < count; ++v) {
        const glm::vec3 t =
            turned[v] == glm::vec3(0) ? glm::vec3(1, 0, 0) : glm::normalize(glm::vec3(1, 0, 0) + turned[v]);
        ASSERT_TRUE(test::is_near(glm::vec3(face.out_tangents[v]), t, 3e-7)) << v;
      }
      if (normals.empty()) normals = face.out_normals;
      EXPECT_TRUE(face.out_normals == normals) << count;
    }
  }
}

TEST(sparse_range, finds_the_entries_of_every_range_of_vertices) {
  test::FixedRandom random(10);
  for (int round = 0; round < 200; ++round) {
    const auto sparse = runs_and_gaps(random, 1 + random.below(400));
    const std::size_t first = random.below(450), count = random.below(450);
    const SparseRange range = sparse_range(sparse.vertices, first, count);
    const auto below = [&](std::size_t vertex) {
      return static_cast<std::size_t>(
          std::count_if(sparse.vertices.begin(), sparse.vertices.end(), [&](std::uint32_t v) { return v < vertex; }));
    };
    EXPECT_EQ(range.begin, below(first));
    EXPECT_EQ(range.end, below(first + count));
  }
}

TEST(morph_vertices, N26_tiny_weights_are_flushed) {
  Face face(1);
  face.morphs.targets.resize(1);
  face.morphs.targets[0].positions = {{0}, {{1, 1, 1}}};
  face.weights = {1e-38f};
  EXPECT_EQ(run(face.job()), ErrorCode::ok);
  EXPECT_EQ(face.out_positions[0], glm::vec3(0));
}

}  // namespace
}  // namespace sinew
