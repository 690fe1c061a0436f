// SPDX-License-Identifier: MIT
// Dual-quaternion skinning of vertices that are sorted into tiles.
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "runtime/deform/skin_dual_quaternion.h"
#include "tests/reference/skinning.h"
#include "tests/support/near.h"
#include "tests/support/shared_joints.h"
#include "tests/support/simd_targets.h"
#include "tests/support/skinned_vertices.h"

namespace sinew {
namespace {

constexpr std::uint32_t kRigidCounts[] = {1, 2, 3, 4, 5, 8, 12};
constexpr std::uint16_t kRigidJoints = 24;

/// Vertices that follow rigid joints on one hemisphere, of which some share joints, and their tiles.
struct RigidVertices {
  test::SkinnedVertices s;
  VertexTiles tiles;
  std::vector<RigidStretch> split{kRigidJoints};
  bool any_stretch = false;
  std::vector<JointPair> pairs = test::all_pairs(kRigidJoints);

  explicit RigidVertices(std::uint64_t seed, std::uint32_t group_size = 50, bool with_scale = false) {
    test::FixedRandom random(seed);
    s = test::random_skinned_vertices(random, kRigidCounts, group_size, kRigidJoints, with_scale);
    test::share_joints(random, s, 3);
    test::pose_on_one_side(random, s.palette, with_scale);
    tiles = tile_vertices(s.influences, s.in());
    split_palette();
  }
  void split_palette() { run_unchecked(SplitPaletteJob{s.palette, split, &any_stretch, {}}); }
  SkinDualQuaternionJob job() {
    return {.influences = &s.influences,
            .split = split,
            .any_stretch = any_stretch,
            .vertices = s.in(),
            .out = s.out(),
            .pairs = pairs,
            .palette = s.palette,
            .tiles = &tiles};
  }
};

/// The bits of all outputs of a job.
struct RigidBits {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec4> tangents;

  RigidBits(const SkinDualQuaternionJob& job, const test::SkinnedVertices& s) {
    EXPECT_EQ(run(job), ErrorCode::ok);
    positions = s.out_positions;
    normals = s.out_normals;
    tangents = s.out_tangents;
  }
  friend bool operator==(const RigidBits& a, const RigidBits& b) {
    const auto same = [](const auto& x, const auto& y) {
      return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(x[0])) == 0;
    };
    return same(a.positions, b.positions) && same(a.normals, b.normals) && same(a.tangents, b.tangents);
  }
};

SkinDualQuaternionJob without_tiles(SkinDualQuaternionJob job) {
  job.tiles = nullptr;
  return job;
}

TEST(skin_rigid_tiles, reject_other_vertices_and_joints_out_of_range) {
  RigidVertices v(1, 3);
  EXPECT_EQ(check(v.job()), ErrorCode::ok);
  VertexTiles fewer = v.tiles;
  --fewer.vertex_count;
  auto job = v.job();
  job.tiles = &fewer;
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  VertexTiles more_joints = v.tiles;
  more_joints.joint_count = kRigidJoints + 1;
  job.tiles = &more_joints;
  EXPECT_EQ(check(job), ErrorCode::index_out_of_range);
}

TEST(skin_rigid_tiles, vertices_agree_with_double_on_every_instruction_set) {
  for (const std::int64_t target : test::simd_targets()) {
    const test::OnlyTarget only(target);
    RigidVertices v(2);
    ASSERT_EQ(run(v.job()), ErrorCode::ok);
    for (std::size_t i = 0; i < v.s.positions.size(); ++i) {
      std::vector<DualQuatd> motions;
      std::vector<double> weights;
      for (const auto j : v.s.joints_of(i))
        motions.push_back({quat_cast<double>(v.split[j].rigid.real), quat_cast<double>(v.split[j].rigid.dual)});
      for (const auto w : v.s.weights_of(i)) weights.push_back(w);
      const auto truth = reference::skin_dual_quaternion<double>(motions, {}, weights, Vec3<double>(v.s.positions[i]),
                                                                 Vec3<double>(v.s.normals[i]));
      const auto tangent = reference::skin_dual_quaternion<double>(motions, {}, weights, Vec3<double>(0.0),
                                                                   Vec3<double>(glm::vec3(v.s.tangents[i])));
      EXPECT_TRUE(test::is_near(Vec3<double>(v.s.out_positions[i]), truth.position, 4e-6)) << i;
      EXPECT_TRUE(test::is_near(Vec3<double>(v.s.out_normals[i]), truth.normal, 1e-6)) << i;
      EXPECT_TRUE(test::is_near(Vec3<double>(glm::vec3(v.s.out_tangents[i])), tangent.normal, 1e-6)) << i;
      EXPECT_EQ(v.s.out_tangents[i].w, v.s.tangents[i].w);
    }
  }
}

TEST(skin_rigid_tiles, groups_of_every_size_have_the_same_bits_on_every_instruction_set) {
  for (const std::uint32_t size : {1u, 3u, 4u, 5u, 9u, 15u, 16u, 17u, 33u, 50u, 200u}) {
    RigidVertices v(size, size);
    v.s.normals[size / 2] = glm::vec3(0);
    const auto bits_on = [&](std::int64_t target) {
      const test::OnlyTarget only(target);
      return RigidBits(v.job(), v.s);
    };
    const RigidBits fused = bits_on(test::simd_targets().front()), unfused = bits_on(test::simd_targets().back());
    for (const std::int64_t target : test::simd_targets())
      EXPECT_TRUE(bits_on(target) == (test::fuses_multiply_add(target) ? fused : unfused))
          << size << ' ' << test::simd_name(target);
  }
}

TEST(skin_rigid_tiles, are_used_and_change_the_result_by_rounding_alone) {
  RigidVertices v(3);
  const RigidBits in_tiles(v.job(), v.s), otherwise(without_tiles(v.job()), v.s);
  EXPECT_FALSE(in_tiles == otherwise);
  for (std::size_t i = 0; i < v.s.positions.size(); ++i) {
    EXPECT_TRUE(test::is_near(in_tiles.positions[i], otherwise.positions[i], 4e-6)) << i;
    EXPECT_TRUE(test::is_near(in_tiles.normals[i], otherwise.normals[i], 1e-6)) << i;
  }
}

TEST(skin_rigid_tiles, are_left_aside_where_joints_stretch) {
  RigidVertices v(4, 50, true);
  ASSERT_TRUE(v.any_stretch);
  EXPECT_TRUE(RigidBits(v.job(), v.s) == RigidBits(without_tiles(v.job()), v.s));
}

TEST(skin_rigid_tiles, are_left_aside_where_rotations_are_on_two_hemispheres_or_pairs_are_not_known) {
  RigidVertices v(5);
  auto job = v.job();
  job.pairs = {};
  EXPECT_TRUE(RigidBits(job, v.s) == RigidBits(without_tiles(job), v.s));
  DualQuat& other_side = v.split[7].rigid;
  other_side.real = -other_side.real;
  other_side.dual = -other_side.dual;
  EXPECT_TRUE(RigidBits(v.job(), v.s) == RigidBits(without_tiles(v.job()), v.s));
}

TEST(skin_rigid_tiles, are_left_aside_where_they_lack_an_attribute) {
  RigidVertices v(6);
  v.tiles = tile_vertices(v.s.influences, {.positions = v.s.positions, .normals = v.s.normals, .tangents = {}});
  EXPECT_TRUE(RigidBits(v.job(), v.s) == RigidBits(without_tiles(v.job()), v.s));
  auto job = v.job();
  job.out.tangents = {};
  EXPECT_FALSE(RigidBits(job, v.s) == RigidBits(without_tiles(job), v.s));
}

TEST(skin_rigid_tiles, the_bind_pose_moves_nothing_by_a_bit) {
  RigidVertices v(7, 20);
  for (JointMatrix& m : v.s.palette) m = {};
  v.split_palette();
  EXPECT_EQ(run(v.job()), ErrorCode::ok);
  EXPECT_EQ(v.s.out_positions, v.s.positions);
}

TEST(skin_rigid_tiles, directions_without_length_take_the_scalar_path) {
  RigidVertices v(8, 20);
  v.s.normals[3] = glm::vec3(0);
  v.s.normals[40] = glm::vec3(0, 1e-25f, 0);
  v.s.tangents[50] = glm::vec4(0, 0, 0, 1);
  v.tiles = tile_vertices(v.s.influences, v.s.in());
  const RigidBits in_tiles(v.job(), v.s), otherwise(without_tiles(v.job()), v.s);
  EXPECT_EQ(in_tiles.normals[3], glm::vec3(0));
  EXPECT_TRUE(test::is_near(in_tiles.normals[40], otherwise.normals[40], 1e-6));
  EXPECT_EQ(in_tiles.tangents[50], v.s.tangents[50]);
}

}  // namespace
}  // namespace sinew
