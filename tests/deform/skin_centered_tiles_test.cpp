// SPDX-License-Identifier: MIT
// Skinning around centers of rotation of vertices that are sorted into tiles.
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "runtime/deform/skin_center_of_rotation.h"
#include "runtime/deform/skin_linear.h"
#include "tests/reference/skinning.h"
#include "tests/support/near.h"
#include "tests/support/shared_joints.h"
#include "tests/support/simd_targets.h"
#include "tests/support/skinned_vertices.h"

namespace sinew {
namespace {

constexpr std::uint32_t kCenteredCounts[] = {1, 2, 3, 4, 5, 8, 12};
constexpr std::uint16_t kCenteredJoints = 24;

/// Vertices with centers that follow rigid joints on one hemisphere, of which some share joints, and their tiles.
struct CenteredVertices {
  test::SkinnedVertices s;
  std::vector<glm::vec3> centers;
  VertexTiles tiles;
  std::vector<RigidStretch> split{kCenteredJoints};
  bool any_stretch = false;
  std::vector<JointPair> pairs = test::all_pairs(kCenteredJoints);

  explicit CenteredVertices(std::uint64_t seed, std::uint32_t group_size = 50, bool with_scale = false) {
    test::FixedRandom random(seed);
    s = test::random_skinned_vertices(random, kCenteredCounts, group_size, kCenteredJoints, with_scale);
    test::share_joints(random, s, 3);
    test::pose_on_one_side(random, s.palette, with_scale);
    centers = s.positions;
    for (glm::vec3& center : centers) center += random.vec3();
    tiles = tile_vertices(s.influences, s.in(), centers);
    EXPECT_EQ(run(SplitPaletteJob{s.palette, split, &any_stretch, {}}), ErrorCode::ok);
  }
  SkinCenterOfRotationJob job() {
    return {.influences = &s.influences,
            .palette = s.palette,
            .split = split,
            .any_stretch = any_stretch,
            .centers = centers,
            .vertices = s.in(),
            .out = s.out(),
            .pairs = pairs,
            .tiles = &tiles};
  }
  SkinCenterOfRotationJob job_without_tiles() {
    SkinCenterOfRotationJob without = job();
    without.tiles = nullptr;
    return without;
  }
};

/// The bits of all outputs of a job.
std::vector<float> centered_bits(const SkinCenterOfRotationJob& job) {
  EXPECT_EQ(run(job), ErrorCode::ok);
  std::vector<float> all;
  const auto add = [&](const auto& span) {
    const auto* first = reinterpret_cast<const float*>(span.data());
    all.insert(all.end(), first, first + span.size_bytes() / sizeof(float));
  };
  add(job.out.positions);
  add(job.out.normals);
  add(job.out.tangents);
  return all;
}

bool same_floats(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

TEST(skin_centered_tiles, reject_other_vertices_joints_out_of_range_and_tiles_without_centers) {
  CenteredVertices v(1, 3);
  EXPECT_EQ(check(v.job()), ErrorCode::ok);
  const auto check_with = [&](const VertexTiles& tiles) {
    auto job = v.job();
    job.tiles = &tiles;
    return check(job);
  };
  VertexTiles fewer = v.tiles;
  --fewer.vertex_count;
  EXPECT_EQ(check_with(fewer), ErrorCode::size_mismatch);
  VertexTiles more_joints = v.tiles;
  more_joints.joint_count = kCenteredJoints + 1;
  EXPECT_EQ(check_with(more_joints), ErrorCode::index_out_of_range);
  EXPECT_EQ(check_with(tile_vertices(v.s.influences, v.s.in())), ErrorCode::size_mismatch);
}

TEST(skin_centered_tiles, vertices_agree_with_double_on_every_instruction_set) {
  for (const std::int64_t target : test::simd_targets()) {
    const test::OnlyTarget only(target);
    CenteredVertices v(2);
    ASSERT_EQ(run(v.job()), ErrorCode::ok);
    for (std::size_t i = 0; i < v.centers.size(); ++i) {
      std::vector<DualQuatd> motions;
      std::vector<Affined> matrices;
      std::vector<double> weights;
      for (const auto j : v.s.joints_of(i)) {
        motions.push_back({quat_cast<double>(v.split[j].rigid.real), quat_cast<double>(v.split[j].rigid.dual)});
        matrices.push_back(affine_cast<double>(affine_from(v.s.palette[j])));
      }
      for (const auto w : v.s.weights_of(i)) weights.push_back(w);
      const auto truth =
          reference::skin_center_of_rotation<double>(motions, matrices, weights, Vec3<double>(v.s.positions[i]),
                                                     Vec3<double>(v.s.normals[i]), Vec3<double>(v.centers[i]));
      EXPECT_TRUE(test::is_near(Vec3<double>(v.s.out_positions[i]), truth.position, 4e-6)) << i;
      EXPECT_TRUE(test::is_near(Vec3<double>(v.s.out_normals[i]), truth.normal, 1e-6)) << i;
      EXPECT_EQ(v.s.out_tangents[i].w, v.s.tangents[i].w);
    }
  }
}

TEST(skin_centered_tiles, groups_of_every_size_have_the_same_bits_on_every_instruction_set) {
  for (const std::uint32_t size : {1u, 3u, 4u, 9u, 15u, 16u, 17u, 50u, 200u}) {
    CenteredVertices v(size, size);
    const auto bits_on = [&](std::int64_t target) {
      const test::OnlyTarget only(target);
      return centered_bits(v.job());
    };
    const auto fused = bits_on(test::simd_targets().front()), unfused = bits_on(test::simd_targets().back());
    for (const std::int64_t target : test::simd_targets())
      EXPECT_TRUE(same_floats(bits_on(target), test::fuses_multiply_add(target) ? fused : unfused))
          << size << ' ' << test::simd_name(target);
  }
}

TEST(skin_centered_tiles, are_used_and_change_the_result_by_rounding_alone) {
  CenteredVertices v(3);
  const std::vector<float> in_tiles = centered_bits(v.job()), otherwise = centered_bits(v.job_without_tiles());
  EXPECT_FALSE(same_floats(in_tiles, otherwise));
  for (std::size_t i = 0; i < in_tiles.size(); ++i) EXPECT_NEAR(in_tiles[i], otherwise[i], 6e-6f) << i;
}

TEST(skin_centered_tiles, are_left_aside_where_joints_stretch_or_an_attribute_is_missing) {
  CenteredVertices stretched(4, 50, true);
  ASSERT_TRUE(stretched.any_stretch);
  EXPECT_TRUE(same_floats(centered_bits(stretched.job()), centered_bits(stretched.job_without_tiles())));
  CenteredVertices v(5);
  v.tiles =
      tile_vertices(v.s.influences, {.positions = v.s.positions, .normals = v.s.normals, .tangents = {}}, v.centers);
  EXPECT_TRUE(same_floats(centered_bits(v.job()), centered_bits(v.job_without_tiles())));
}

TEST(skin_centered_tiles, a_vertex_with_one_joint_is_blended_linearly_about_any_center) {
  CenteredVertices v(6);
  EXPECT_EQ(run(v.job()), ErrorCode::ok);
  const auto around_centers = v.s.out_positions;
  EXPECT_EQ(
      run(SkinLinearJob{.influences = &v.s.influences, .palette = v.s.palette, .vertices = v.s.in(), .out = v.s.out()}),
      ErrorCode::ok);
  for (std::size_t i = 0; i < 50; ++i) EXPECT_TRUE(test::is_near(around_centers[i], v.s.out_positions[i], 1e-6)) << i;
}

TEST(skin_centered_tiles, directions_without_length_take_the_scalar_path) {
  CenteredVertices v(8, 20);
  v.s.normals[3] = glm::vec3(0);
  v.s.tangents[50] = glm::vec4(0, 0, 0, 1);
  v.tiles = tile_vertices(v.s.influences, v.s.in(), v.centers);
  EXPECT_EQ(run(v.job()), ErrorCode::ok);
  EXPECT_EQ(v.s.out_normals[3], glm::vec3(0));
  EXPECT_EQ(v.s.out_tangents[50], v.s.tangents[50]);
}

}  // namespace
}  // namespace sinew
