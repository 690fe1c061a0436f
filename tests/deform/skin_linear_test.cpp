// SPDX-License-Identifier: MIT
#include "runtime/deform/skin_linear.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

#include "tests/reference/skinning.h"
#include "tests/support/near.h"
#include "tests/support/skinned_vertices.h"

namespace sinew {
namespace {

constexpr std::uint32_t kLinearCounts[] = {1, 2, 3, 4, 5, 8, 12};

SkinLinearJob job_of(test::SkinnedVertices& s) {
  return {.influences = &s.influences, .palette = s.palette, .vertices = s.in(), .out = s.out()};
}

/// Double-precision blend of the matrices of vertex v.
Affined truth_matrix(const test::SkinnedVertices& s, std::size_t v) {
  std::vector<Affined> matrices;
  std::vector<double> weights;
  for (const auto j : s.joints_of(v)) matrices.push_back(affine_cast<double>(affine_from(s.palette[j])));
  for (const auto w : s.weights_of(v)) weights.push_back(w);
  return reference::blend_matrices<double>(matrices, weights);
}

TEST(skin_linear, rejects_wrong_sizes_and_joints_out_of_range) {
  test::FixedRandom random(1);
  auto s = test::random_skinned_vertices(random, kLinearCounts, 3, 16, true);
  EXPECT_EQ(check(job_of(s)), ErrorCode::ok);
  auto job = job_of(s);
  job.influences = nullptr;
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = job_of(s);
  job.palette = job.palette.first(2);
  EXPECT_EQ(check(job), ErrorCode::index_out_of_range);
  job = job_of(s);
  job.out.positions = job.out.positions.first(1);
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = job_of(s);
  job.vertices.normals = job.vertices.normals.first(1);
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  s.influences.groups.pop_back();
  EXPECT_EQ(check(job_of(s)), ErrorCode::size_mismatch);
}

TEST(skin_linear, no_vertices_is_no_work) {
  test::SkinnedVertices s;
  EXPECT_EQ(check(job_of(s)), ErrorCode::ok);
  EXPECT_EQ(run(job_of(s)), ErrorCode::ok);
}

TEST(skin_linear, random_vertices_agree_with_double_for_every_influence_count) {
  test::FixedRandom random(2);
  auto s = test::random_skinned_vertices(random, kLinearCounts, 50, 24, true);
  EXPECT_EQ(run(job_of(s)), ErrorCode::ok);
  for (std::size_t v = 0; v < s.positions.size(); ++v) {
    const Affined m = truth_matrix(s, v);
    EXPECT_TRUE(test::is_near(Vec3<double>(s.out_positions[v]), transform_point(m, Vec3<double>(s.positions[v])), 4e-6))
        << v;
    const auto n = glm::normalize(transform_vector(m, Vec3<double>(s.normals[v])));
    EXPECT_TRUE(test::is_near(Vec3<double>(s.out_normals[v]), n, 2e-5)) << v;
    const auto t = glm::normalize(transform_vector(m, Vec3<double>(glm::vec3(s.tangents[v]))));
    EXPECT_TRUE(test::is_near(Vec3<double>(glm::vec3(s.out_tangents[v])), t, 2e-5)) << v;
    EXPECT_EQ(s.out_tangents[v].w, s.tangents[v].w);
  }
}

TEST(skin_linear, normals_of_single_influences_do_not_depend_on_the_weight_on_the_scalar_path) {
  test::FixedRandom random(7);
  constexpr std::uint32_t kSingle[] = {1};
  auto s = test::random_skinned_vertices(random, kSingle, 64, 24, true);
  for (JointMatrix& m : s.palette)
    for (glm::vec4& column : m.column) column *= 1e-17f;  // squares leave the range of float
  ASSERT_EQ(run(job_of(s)), ErrorCode::ok);
  const auto normals = s.out_normals;
  const auto tangents = s.out_tangents;
  std::fill(s.influences.weights.begin(), s.influences.weights.end(), 0.3f);
  ASSERT_EQ(run(job_of(s)), ErrorCode::ok);
  EXPECT_EQ(s.out_normals, normals);
  EXPECT_EQ(s.out_tangents, tangents);
}

TEST(skin_linear, N22_cofactor_normals_stay_square_to_the_moved_surface) {
  test::FixedRandom random(3);
  auto s = test::random_skinned_vertices(random, kLinearCounts, 50, 24, true);
  auto job = job_of(s);
  job.normal_rule = NormalRule::cofactor;
  EXPECT_EQ(run(job), ErrorCode::ok);
  for (std::size_t v = 0; v < s.positions.size(); ++v) {
    const auto n = transform_normal_outward(linear_part(truth_matrix(s, v)), Vec3<double>(s.normals[v]));
    EXPECT_TRUE(test::is_near(Vec3<double>(s.out_normals[v]), n, 4e-5)) << v;
  }
}

TEST(skin_linear, N22_a_collapsed_matrix_keeps_the_normal) {
  test::FixedRandom random(4);
  auto s = test::random_skinned_vertices(random, kLinearCounts, 2, 16, true);
  for (auto& m : s.palette) m = joint_matrix_from(affine_from(Mat3<float>(0.0f), {1, 2, 3}));
  for (const auto rule : {NormalRule::linear, NormalRule::cofactor}) {
    auto job = job_of(s);
    job.normal_rule = rule;
    EXPECT_EQ(run(job), ErrorCode::ok);
    for (std::size_t v = 0; v < s.positions.size(); ++v) EXPECT_EQ(s.out_normals[v], s.normals[v]);
  }
}

TEST(skin_linear, N22_a_tangent_without_length_keeps_its_value_beside_normals_that_have_one) {
  test::FixedRandom random(14);
  auto s = test::random_skinned_vertices(random, kLinearCounts, 40, 16, true);
  for (std::size_t v = 0; v < s.tangents.size(); v += 3) s.tangents[v] = {0, 0, 0, -1};
  EXPECT_EQ(run(job_of(s)), ErrorCode::ok);
  for (std::size_t v = 0; v < s.tangents.size(); v += 3) EXPECT_EQ(s.out_tangents[v], s.tangents[v]) << v;
}

TEST(skin_linear, the_bind_pose_moves_nothing) {
  test::FixedRandom random(5);
  auto s = test::random_skinned_vertices(random, kLinearCounts, 10, 16, false);
  for (auto& m : s.palette) m = {};
  EXPECT_EQ(run(job_of(s)), ErrorCode::ok);
  for (std::size_t v = 0; v < s.positions.size(); ++v)
    EXPECT_TRUE(test::is_near(s.out_positions[v], s.positions[v], 1e-6)) << v;
}

TEST(skin_linear, rigid_motion_commutes_with_skinning) {
  test::FixedRandom random(6);
  auto s = test::random_skinned_vertices(random, kLinearCounts, 10, 16, true);
  EXPECT_EQ(run(job_of(s)), ErrorCode::ok);
  const auto before = s.out_positions;
  Transform t = random.transform();
  t.scale = glm::vec3(1);
  const Affine motion = affine_from_transform(t);
  for (auto& m : s.palette) m = joint_matrix_from(motion * affine_from(m));
  EXPECT_EQ(run(job_of(s)), ErrorCode::ok);
  for (std::size_t v = 0; v < before.size(); ++v)
    EXPECT_TRUE(test::is_near(s.out_positions[v], transform_point(motion, before[v]), 1e-5)) << v;
}

TEST(skin_linear, attributes_that_are_not_wanted_are_not_written) {
  test::FixedRandom random(7);
  auto s = test::random_skinned_vertices(random, kLinearCounts, 4, 16, true);
  auto job = job_of(s);
  job.out.normals = {};
  job.out.tangents = {};
  EXPECT_EQ(run(job), ErrorCode::ok);
  for (const auto& n : s.out_normals) EXPECT_EQ(n, glm::vec3(0));
  for (const auto& t : s.out_tangents) EXPECT_EQ(t, glm::vec4(0));
  const auto positions = s.out_positions;
  EXPECT_EQ(run(job_of(s)), ErrorCode::ok);
  EXPECT_TRUE(s.out_positions == positions);
}

TEST(skin_linear, N20_half_and_half_twist_shrinks_by_the_cosine_of_half_the_angle) {
  test::SkinnedVertices s;
  s.positions = {{0, 0, 1}};
  s.out_positions.resize(1);
  s.influences = {{{0, 1, 2, 0}}, {0, 1}, {0.5f, 0.5f}};
  for (const double degrees : {90.0, 150.0, 179.0}) {
    const double half = degrees * 0.5 * 3.14159265358979 / 180;
    Transform turned;
    turned.rotation = quat_cast<float>(quat_xyzw(0.0, std::sin(half), 0.0, std::cos(half)));
    s.palette = {JointMatrix{}, joint_matrix_from(affine_from_transform(turned))};
    EXPECT_EQ(run(job_of(s)), ErrorCode::ok);
    EXPECT_NEAR(glm::length(s.out_positions[0]), std::cos(half), 1e-6) << degrees;
  }
}

}  // namespace
}  // namespace sinew
