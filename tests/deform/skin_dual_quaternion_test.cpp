// SPDX-License-Identifier: MIT
#include "runtime/deform/skin_dual_quaternion.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <vector>

#include "runtime/deform/skin_linear.h"
#include "runtime/math/decompose.h"
#include "tests/reference/skinning.h"
#include "tests/support/near.h"
#include "tests/support/simd_targets.h"
#include "tests/support/skinned_vertices.h"

namespace sinew {
namespace {

constexpr std::uint32_t kDualCounts[] = {1, 2, 3, 4, 5, 8, 12};

/// The vertices with their palette split for the job.
struct Split {
  test::SkinnedVertices vertices;
  std::vector<RigidStretch> split;
  bool any_stretch = false;

  explicit Split(test::SkinnedVertices v) : vertices(std::move(v)) { refresh(); }
  void refresh() {
    split.resize(vertices.palette.size());
    EXPECT_EQ(run(SplitPaletteJob{vertices.palette, split, &any_stretch}), ErrorCode::ok);
  }
  SkinDualQuaternionJob job() {
    return {.influences = &vertices.influences,
            .split = split,
            .any_stretch = any_stretch,
            .vertices = vertices.in(),
            .out = vertices.out()};
  }
};

reference::SkinnedT<double> truth(const Split& s, std::size_t v) {
  std::vector<DualQuatd> motions;
  std::vector<Mat3<double>> stretches;
  std::vector<double> weights;
  for (const auto j : s.vertices.joints_of(v)) {
    const auto& rigid = s.split[j].rigid;
    motions.push_back({quat_cast<double>(rigid.real), quat_cast<double>(rigid.dual)});
    stretches.push_back(Mat3<double>(matrix_from_stretch(s.split[j].stretch)));
  }
  for (const auto w : s.vertices.weights_of(v)) weights.push_back(w);
  if (!s.any_stretch) stretches.clear();
  return reference::skin_dual_quaternion<double>(motions, stretches, weights, Vec3<double>(s.vertices.positions[v]),
                                                 Vec3<double>(s.vertices.normals[v]));
}

void expect_truth(Split& s) {
  EXPECT_EQ(run(s.job()), ErrorCode::ok);
  for (std::size_t v = 0; v < s.vertices.positions.size(); ++v) {
    const auto expected = truth(s, v);
    // random rotations nearly cancel now and then; their blend loses digits by 1 / its length
    EXPECT_TRUE(test::is_near(Vec3<double>(s.vertices.out_positions[v]), expected.position, 1e-4)) << v;
    EXPECT_TRUE(test::is_near(Vec3<double>(s.vertices.out_normals[v]), expected.normal, 1e-4)) << v;
    EXPECT_NEAR(glm::length(s.vertices.out_normals[v]), 1.0f, 1e-6f) << v;
    EXPECT_EQ(s.vertices.out_tangents[v].w, s.vertices.tangents[v].w);
  }
}

TEST(skin_dual_quaternion, rejects_wrong_sizes_and_joints_out_of_range) {
  test::FixedRandom random(1);
  Split s(test::random_skinned_vertices(random, kDualCounts, 3, 16, true));
  EXPECT_EQ(check(s.job()), ErrorCode::ok);
  auto job = s.job();
  job.influences = nullptr;
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = s.job();
  job.split = job.split.first(2);
  EXPECT_EQ(check(job), ErrorCode::index_out_of_range);
  job = s.job();
  job.palette = s.vertices.palette;
  EXPECT_EQ(check(job), ErrorCode::ok);
  job.palette = job.palette.first(job.split.size() - 1);
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = s.job();
  job.out.normals = job.out.normals.first(1);
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
}

TEST(skin_dual_quaternion, random_rigid_palettes_agree_with_double) {
  test::FixedRandom random(2);
  Split s(test::random_skinned_vertices(random, kDualCounts, 50, 24, false));
  EXPECT_FALSE(s.any_stretch);
  expect_truth(s);
}

TEST(skin_dual_quaternion, N19_random_stretched_palettes_agree_with_double) {
  test::FixedRandom random(3);
  Split s(test::random_skinned_vertices(random, kDualCounts, 50, 24, true));
  EXPECT_TRUE(s.any_stretch);
  expect_truth(s);
}

TEST(skin_dual_quaternion, N17_signs_of_the_same_rotation_do_not_matter) {
  test::FixedRandom random(4);
  Split s(test::random_skinned_vertices(random, kDualCounts, 20, 24, false));
  EXPECT_EQ(run(s.job()), ErrorCode::ok);
  const auto before = s.vertices.out_positions;
  for (std::size_t j = 0; j < s.split.size(); j += 2) {
    s.split[j].rigid.real = -s.split[j].rigid.real;
    s.split[j].rigid.dual = -s.split[j].rigid.dual;
  }
  EXPECT_EQ(run(s.job()), ErrorCode::ok);
  for (std::size_t v = 0; v < before.size(); ++v)
    EXPECT_TRUE(test::is_near(s.vertices.out_positions[v], before[v], 1e-6)) << v;
}

TEST(skin_dual_quaternion, N17_known_pairs_change_no_bit_on_one_side_or_not) {
  test::FixedRandom random(44);
  for (const double turn_rad : {0.5, 3.0}) {
    Split s(test::random_skinned_vertices(random, kDualCounts, 40, 24, false));
    for (auto& m : s.vertices.palette)
      m = joint_matrix_from(
          affine_from_transform(Transform{random.vec3(), random.rotation_by(turn_rad), glm::vec3(1)}));
    std::vector<JointPair> follow, pairs;
    for (std::uint16_t j = 1; j < 24; ++j) follow.push_back({0, j});
    for (std::uint16_t j = 0; j < 24; ++j)
      for (std::uint16_t k = 0; k < 24; ++k) pairs.push_back({j, k});
    EXPECT_EQ(run(SplitPaletteJob{s.vertices.palette, s.split, &s.any_stretch, follow}), ErrorCode::ok);
    EXPECT_EQ(run(s.job()), ErrorCode::ok);
    const auto positions = s.vertices.out_positions, normals = s.vertices.out_normals;
    auto job = s.job();
    job.pairs = pairs;
    ASSERT_EQ(run(job), ErrorCode::ok);
    EXPECT_TRUE(s.vertices.out_positions == positions) << turn_rad;
    EXPECT_TRUE(s.vertices.out_normals == normals) << turn_rad;
    s.split[3].rigid = {-s.split[3].rigid.real, -s.split[3].rigid.dual};
    const JointPair wrong[] = {{1, 2}};  // a list that misses pairs is believed
    job.pairs = wrong;
    EXPECT_EQ(run(job), ErrorCode::ok);
    EXPECT_EQ(s.vertices.out_positions == positions,
              turn_rad > 1.0 && !(quat_dot(s.split[1].rigid.real, s.split[2].rigid.real) > 1e-5f))
        << turn_rad;
    job.pairs = pairs;
    EXPECT_EQ(run(job), ErrorCode::ok);
    EXPECT_TRUE(s.vertices.out_positions == positions) << turn_rad;
  }
}

TEST(skin_dual_quaternion, N19_known_pairs_change_no_bit_of_stretched_joints_either) {
  test::FixedRandom random(45);
  for (const std::uint32_t group_size : {3u, 40u}) {
    Split s(test::random_skinned_vertices(random, kDualCounts, group_size, 24, true));
    test::pose_on_one_side(random, s.vertices.palette, true);
    s.refresh();
    ASSERT_TRUE(s.any_stretch);
    for (const std::int64_t target : test::simd_targets()) {
      const test::OnlyTarget only(target);
      EXPECT_EQ(run(s.job()), ErrorCode::ok);
      const auto positions = s.vertices.out_positions, normals = s.vertices.out_normals;
      auto job = s.job();
      const std::vector<JointPair> pairs = test::all_pairs(24);
      job.pairs = pairs;
      EXPECT_EQ(run(job), ErrorCode::ok);
      EXPECT_TRUE(s.vertices.out_positions == positions) << group_size << ' ' << test::simd_name(target);
      EXPECT_TRUE(s.vertices.out_normals == normals) << group_size << ' ' << test::simd_name(target);
    }
  }
}

TEST(skin_dual_quaternion, N20_half_and_half_twist_keeps_the_radius) {
  test::SkinnedVertices v;
  v.positions = {{0, 0, 1}};
  v.out_positions.resize(1);
  v.influences = {{{0, 1, 2, 0}}, {0, 1}, {0.5f, 0.5f}};
  for (const double degrees : {0.0, 90.0, 150.0, 179.0, 180.0}) {
    const double half = degrees * 0.5 * 3.14159265358979 / 180;
    Transform turned;
    turned.rotation = quat_cast<float>(quat_xyzw(0.0, std::sin(half), 0.0, std::cos(half)));
    v.palette = {JointMatrix{}, joint_matrix_from(affine_from_transform(turned))};
    Split s(v);
    EXPECT_EQ(run(s.job()), ErrorCode::ok);
    EXPECT_NEAR(glm::length(s.vertices.out_positions[0]), 1.0f, 1e-6f) << degrees;
  }
}

TEST(skin_dual_quaternion, N18_the_skin_moves_continuously_while_a_joint_turns_twice) {
  test::SkinnedVertices v;
  v.positions = {{0, 0, 1}, {0, 0, 1}};
  v.out_positions.resize(2);
  v.influences = {{{0, 2, 2, 0}}, {0, 1, 0, 1}, {0.7f, 0.3f, 0.6f, 0.4f}};
  std::vector<glm::vec3> last;
  int jumps = 0;
  for (int step = 0; step <= 720; ++step) {
    const double half = step * 0.5 * 3.14159265358979 / 180;
    Transform turned;
    turned.rotation = quat_cast<float>(quat_xyzw(0.0, std::sin(half), 0.0, std::cos(half)));
    v.palette = {JointMatrix{}, joint_matrix_from(affine_from_transform(turned))};
    Split s(v);
    EXPECT_EQ(run(s.job()), ErrorCode::ok);
    if (!last.empty())
      for (std::size_t i = 0; i < 2; ++i) jumps += glm::length(s.vertices.out_positions[i] - last[i]) > 0.1f;
    last = s.vertices.out_positions;
  }
  // The documented exception: at 180 and 540 degrees the short way round changes side, once per vertex and turn.
  EXPECT_EQ(jumps, 4);
}

TEST(skin_dual_quaternion, a_single_influence_is_the_joint_itself) {
  test::FixedRandom random(6);
  const std::uint32_t one[] = {1};
  Split s(test::random_skinned_vertices(random, one, 50, 8, true));
  EXPECT_EQ(run(s.job()), ErrorCode::ok);
  for (std::size_t v = 0; v < s.vertices.positions.size(); ++v)
    EXPECT_TRUE(test::is_near(
        s.vertices.out_positions[v],
        transform_point(affine_from(s.vertices.palette[s.vertices.joints_of(v)[0]]), s.vertices.positions[v]), 2e-6));
}

TEST(skin_dual_quaternion, a_single_influence_has_the_bits_of_linear_blending_where_the_palette_is_known) {
  test::FixedRandom random(61);
  for (const bool stretched : {false, true}) {
    Split s(test::random_skinned_vertices(random, kDualCounts, 20, 24, stretched));
    EXPECT_EQ(run(s.job()), ErrorCode::ok);
    const auto without = s.vertices.out_positions;
    auto job = s.job();
    job.palette = s.vertices.palette;
    EXPECT_EQ(run(job), ErrorCode::ok);
    const auto positions = s.vertices.out_positions, normals = s.vertices.out_normals;
    EXPECT_EQ(run(SkinLinearJob{&s.vertices.influences, s.vertices.palette, s.vertices.in(), s.vertices.out(),
                                stretched ? NormalRule::cofactor : NormalRule::linear}),
              ErrorCode::ok);
    for (std::size_t v = 0; v < positions.size(); ++v) {
      const bool single = s.vertices.joints_of(v).size() == 1;
      EXPECT_EQ(positions[v], single ? s.vertices.out_positions[v] : without[v]) << v;
      EXPECT_TRUE(!single || normals[v] == s.vertices.out_normals[v]) << v;
    }
  }
}

TEST(skin_dual_quaternion, rigid_motion_commutes_with_skinning) {
  test::FixedRandom random(7);
  Split s(test::random_skinned_vertices(random, kDualCounts, 10, 16, false));
  for (auto& m : s.vertices.palette) {  // keep rotations close, so that no sign decision is near its edge
    Transform t = random.transform();
    t.rotation = random.rotation_by(0.5);
    t.scale = glm::vec3(1);
    m = joint_matrix_from(affine_from_transform(t));
  }
  s.refresh();
  EXPECT_EQ(run(s.job()), ErrorCode::ok);
  const auto before = s.vertices.out_positions;
  Transform t = random.transform();
  t.scale = glm::vec3(1);
  const Affine motion = affine_from_transform(t);
  for (auto& m : s.vertices.palette) m = joint_matrix_from(motion * affine_from(m));
  s.refresh();
  EXPECT_EQ(run(s.job()), ErrorCode::ok);
  for (std::size_t v = 0; v < before.size(); ++v)
    EXPECT_TRUE(test::is_near(s.vertices.out_positions[v], transform_point(motion, before[v]), 1e-5)) << v;
}

}  // namespace
}  // namespace sinew
