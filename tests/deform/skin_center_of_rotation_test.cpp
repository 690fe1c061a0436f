// SPDX-License-Identifier: MIT
#include "runtime/deform/skin_center_of_rotation.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <vector>

#include "runtime/deform/skin_linear.h"
#include "tests/reference/skinning.h"
#include "tests/support/near.h"
#include "tests/support/simd_targets.h"
#include "tests/support/skinned_vertices.h"

namespace sinew {
namespace {

constexpr std::uint32_t kTurnedCounts[] = {1, 2, 3, 4, 5, 8};

struct Turned {
  test::SkinnedVertices vertices;
  std::vector<RigidStretch> split;
  std::vector<glm::vec3> centers;
  bool any_stretch = false;

  explicit Turned(test::SkinnedVertices v) : vertices(std::move(v)) {
    split.resize(vertices.palette.size());
    EXPECT_EQ(run(SplitPaletteJob{vertices.palette, split, &any_stretch}), ErrorCode::ok);
    centers = vertices.positions;
  }
  SkinCenterOfRotationJob job() {
    return {.influences = &vertices.influences,
            .palette = vertices.palette,
            .split = split,
            .any_stretch = any_stretch,
            .centers = centers,
            .vertices = vertices.in(),
            .out = vertices.out()};
  }
};

TEST(skin_center_of_rotation, rejects_wrong_sizes_and_joints_out_of_range) {
  test::FixedRandom random(1);
  Turned s(test::random_skinned_vertices(random, kTurnedCounts, 3, 16, true));
  EXPECT_EQ(check(s.job()), ErrorCode::ok);
  auto job = s.job();
  job.centers = job.centers.first(1);
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = s.job();
  const JointPair outside[] = {{0, 16}};
  job.pairs = outside;
  EXPECT_EQ(check(job), ErrorCode::index_out_of_range);
  job = s.job();
  job.split = job.split.first(2);
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job.palette = job.palette.first(2);
  EXPECT_EQ(check(job), ErrorCode::index_out_of_range);
}

TEST(skin_center_of_rotation, N17_known_pairs_change_no_bit) {
  test::FixedRandom random(46);
  for (const bool stretched : {false, true}) {
    Turned s(test::random_skinned_vertices(random, kTurnedCounts, 40, 24, stretched));
    test::pose_on_one_side(random, s.vertices.palette, stretched);
    EXPECT_EQ(run(SplitPaletteJob{s.vertices.palette, s.split, &s.any_stretch}), ErrorCode::ok);
    for (auto& c : s.centers) c += random.vec3();
    for (const std::int64_t target : test::simd_targets()) {
      const test::OnlyTarget only(target);
      EXPECT_EQ(run(s.job()), ErrorCode::ok);
      const auto positions = s.vertices.out_positions, normals = s.vertices.out_normals;
      auto job = s.job();
      const std::vector<JointPair> pairs = test::all_pairs(24);
      job.pairs = pairs;
      EXPECT_EQ(run(job), ErrorCode::ok);
      EXPECT_TRUE(s.vertices.out_positions == positions) << test::simd_name(target);
      EXPECT_TRUE(s.vertices.out_normals == normals) << test::simd_name(target);
    }
  }
}

TEST(skin_center_of_rotation, N21_a_single_influence_is_the_joint_itself_about_any_center) {
  test::FixedRandom random(47);
  const std::uint32_t one[] = {1};
  Turned s(test::random_skinned_vertices(random, one, 50, 8, true));
  for (auto& c : s.centers) c += random.vec3();
  EXPECT_EQ(run(s.job()), ErrorCode::ok);
  const auto positions = s.vertices.out_positions, normals = s.vertices.out_normals;
  EXPECT_EQ(run(SkinLinearJob{&s.vertices.influences, s.vertices.palette, s.vertices.in(), s.vertices.out(),
                              NormalRule::cofactor}),
            ErrorCode::ok);
  EXPECT_TRUE(s.vertices.out_positions == positions);
  EXPECT_TRUE(s.vertices.out_normals == normals);
}

TEST(skin_center_of_rotation, N21_random_rigid_palettes_agree_with_double) {
  test::FixedRandom random(2);
  Turned s(test::random_skinned_vertices(random, kTurnedCounts, 50, 24, false));
  for (auto& c : s.centers) c += random.vec3();
  EXPECT_EQ(run(s.job()), ErrorCode::ok);
  for (std::size_t v = 0; v < s.centers.size(); ++v) {
    std::vector<DualQuatd> motions;
    std::vector<Affined> matrices;
    std::vector<double> weights;
    for (const auto j : s.vertices.joints_of(v)) {
      motions.push_back({quat_cast<double>(s.split[j].rigid.real), quat_cast<double>(s.split[j].rigid.dual)});
      matrices.push_back(affine_cast<double>(affine_from(s.vertices.palette[j])));
    }
    for (const auto w : s.vertices.weights_of(v)) weights.push_back(w);
    const auto truth =
        reference::skin_center_of_rotation<double>(motions, matrices, weights, Vec3<double>(s.vertices.positions[v]),
                                                   Vec3<double>(s.vertices.normals[v]), Vec3<double>(s.centers[v]));
    EXPECT_TRUE(test::is_near(Vec3<double>(s.vertices.out_positions[v]), truth.position, 5e-5)) << v;
    EXPECT_TRUE(test::is_near(Vec3<double>(s.vertices.out_normals[v]), truth.normal, 5e-5)) << v;
  }
}

TEST(skin_center_of_rotation, N21_a_vertex_at_its_own_center_is_linearly_blended) {
  test::FixedRandom random(3);
  Turned s(test::random_skinned_vertices(random, kTurnedCounts, 10, 16, true));
  EXPECT_EQ(run(s.job()), ErrorCode::ok);
  const auto around_centers = s.vertices.out_positions;
  EXPECT_EQ(run(SkinLinearJob{.influences = &s.vertices.influences,
                              .palette = s.vertices.palette,
                              .vertices = s.vertices.in(),
                              .out = s.vertices.out()}),
            ErrorCode::ok);
  for (std::size_t v = 0; v < around_centers.size(); ++v)
    EXPECT_TRUE(test::is_near(around_centers[v], s.vertices.out_positions[v], 2e-6)) << v;
}

TEST(skin_center_of_rotation, N19_a_single_scaled_joint_moves_the_vertex_as_its_matrix_does) {
  test::FixedRandom random(4);
  const std::uint32_t one[] = {1};
  Turned s(test::random_skinned_vertices(random, one, 30, 8, true));
  for (auto& c : s.centers) c += random.vec3();
  EXPECT_EQ(run(s.job()), ErrorCode::ok);
  for (std::size_t v = 0; v < s.centers.size(); ++v) {
    const Affine m = affine_from(s.vertices.palette[s.vertices.joints_of(v)[0]]);
    EXPECT_TRUE(test::is_near(s.vertices.out_positions[v], transform_point(m, s.vertices.positions[v]), 3e-6)) << v;
    EXPECT_TRUE(
        test::is_near(s.vertices.out_normals[v], transform_normal_outward(linear_part(m), s.vertices.normals[v]), 3e-6))
        << v;
  }
}

TEST(skin_center_of_rotation, N20_twist_about_the_center_keeps_the_radius) {
  test::SkinnedVertices v;
  v.positions = {{0, 0, 1}};
  v.out_positions.resize(1);
  v.influences = {{{0, 1, 2, 0}}, {0, 1}, {0.5f, 0.5f}};
  for (const double degrees : {0.0, 90.0, 150.0, 179.0}) {
    const double half = degrees * 0.5 * 3.14159265358979 / 180;
    Transform turned;
    turned.rotation = quat_cast<float>(quat_xyzw(0.0, std::sin(half), 0.0, std::cos(half)));
    v.palette = {JointMatrix{}, joint_matrix_from(affine_from_transform(turned))};
    Turned s(v);
    s.centers[0] = glm::vec3(0);
    EXPECT_EQ(run(s.job()), ErrorCode::ok);
    EXPECT_NEAR(glm::length(s.vertices.out_positions[0]), 1.0f, 1e-6f) << degrees;
  }
}

}  // namespace
}  // namespace sinew
