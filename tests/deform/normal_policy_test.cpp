// SPDX-License-Identifier: MIT
/// Normals and tangents of all kinds of skinning under non-uniform scale and mirroring (conventions.h).
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "runtime/math/decompose.h"
#include "runtime/math/matrix_rotation.h"
#include "tests/reference/skinning.h"
#include "tests/support/near.h"
#include "tests/support/simd_targets.h"
#include "tests/support/skinning_ways.h"

namespace sinew {
namespace {

using test::Way;
using Vec3d = Vec3<double>;

constexpr std::uint32_t kSphereCounts[] = {1, 2, 3, 4, 6};

/// Vertices of a unit sphere: each is its own outward normal.
test::SkinnedVertices sphere(test::FixedRandom& random, std::span<const std::uint32_t> counts) {
  auto s = test::random_skinned_vertices(random, counts, 21, 12, true);
  for (std::size_t v = 0; v < s.positions.size(); ++v) {
    s.positions[v] = s.normals[v];
    const glm::vec3 t = glm::normalize(glm::cross(s.normals[v], random.direction()));
    s.tangents[v] = glm::vec4(t, s.tangents[v].w);
  }
  return s;
}

/// Joints that differ by small turns, under one transform with the given scale.
void pose(test::SkinnedVertices& s, test::FixedRandom& random, const glm::vec3& scale, double turn_rad) {
  const Affine base = affine_from_transform(Transform{{0, 0, 0}, random.rotation(), scale});
  for (JointMatrix& m : s.palette)
    m = joint_matrix_from(base *
                          affine_from_transform(Transform{{0, 0, 0}, random.rotation_by(turn_rad), glm::vec3(1)}));
}

class NormalPolicy : public testing::TestWithParam<Way> {};

/// All but the linear rule, which is exact for rigid and uniformly scaled joints only.
class ExactNormals : public NormalPolicy {};

TEST_P(NormalPolicy, G48_normals_keep_to_the_outside_where_joints_mirror) {
  test::FixedRandom random(11);
  for (const glm::vec3 scale :
       {glm::vec3(1, 1, 1), glm::vec3(-1, 1, 1), glm::vec3(2, -0.5f, 1), glm::vec3(-1, -1, -1)}) {
    auto s = sphere(random, kSphereCounts);
    pose(s, random, scale, 0.2);
    const std::vector<glm::vec3> centers(s.positions.size(), glm::vec3(0));
    skin(GetParam(), s, centers);
    for (std::size_t v = 0; v < s.positions.size(); ++v) {
      EXPECT_GT(glm::dot(s.out_normals[v], s.out_positions[v]), 0.1f)
          << "vertex " << v << " scale " << scale.x << ' ' << scale.y;
      EXPECT_NEAR(glm::length(s.out_normals[v]), 1.0f, 1e-6f);
    }
  }
}

TEST_P(ExactNormals, N22_normals_of_one_joint_are_its_inverse_transpose_under_any_scale) {
  test::FixedRandom random(12);
  const std::uint32_t one[] = {1};
  for (const glm::vec3 scale : {glm::vec3(1, 2, 0.25f), glm::vec3(-3, 1, 0.5f), glm::vec3(-1, -2, -0.125f)}) {
    auto s = sphere(random, one);
    pose(s, random, scale, 3.0);
    skin(GetParam(), s, s.positions);
    for (std::size_t v = 0; v < s.positions.size(); ++v) {
      const auto m = Mat3<double>(linear_part(affine_from(s.palette[s.joints_of(v)[0]])));
      const Vec3d expected = glm::normalize(glm::transpose(glm::inverse(m)) * Vec3d(s.normals[v]));
      EXPECT_TRUE(test::is_near(Vec3d(s.out_normals[v]), expected, 2e-6)) << v;
    }
  }
}

TEST_P(NormalPolicy, N22_tangents_stay_in_the_surface_and_the_bitangent_turns_with_the_winding) {
  test::FixedRandom random(13);
  const std::uint32_t one[] = {1};
  const bool exact = GetParam() != Way::linear;
  for (const glm::vec3 scale :
       {glm::vec3(2, 2, 2), glm::vec3(1, 2, 0.25f), glm::vec3(-3, 1, 0.5f), glm::vec3(-1, 1, 1)}) {
    auto s = sphere(random, one);
    pose(s, random, scale, 3.0);
    skin(GetParam(), s, s.positions);
    const float side = scale.x < 0 ? -1.0f : 1.0f;
    for (std::size_t v = 0; v < s.positions.size(); ++v) {
      const Affine m = affine_from(s.palette[s.joints_of(v)[0]]);
      const glm::vec3 t(s.tangents[v]), moved(s.out_tangents[v]);
      EXPECT_TRUE(test::is_near(moved, glm::normalize(transform_vector(m, t)), 2e-6)) << v;
      EXPECT_EQ(s.out_tangents[v].w, s.tangents[v].w);
      if (exact) {
        EXPECT_NEAR(glm::dot(moved, s.out_normals[v]), 0.0f, 2e-6f) << v;
      }
      const glm::vec3 bitangent = transform_vector(m, glm::cross(s.normals[v], t) * s.tangents[v].w);
      EXPECT_GT(glm::dot(bitangent, glm::cross(s.out_normals[v], moved) * (side * s.tangents[v].w)), 0.0f) << v;
    }
  }
}

TEST_P(ExactNormals, N22_flat_joints_give_the_side_of_the_winding_not_of_rounding) {
  test::FixedRandom random(14);
  const std::uint32_t one[] = {1};
  for (int i = 0; i < 20; ++i) {
    auto s = sphere(random, one);
    pose(s, random, {1, 0, 1}, 0.0);  // all joints equal: rounding alone decides the sign of the determinant
    skin(GetParam(), s, s.positions);
    const Mat3<float> m = linear_part(affine_from(s.palette[0]));
    const glm::vec3 winding = glm::normalize(glm::cross(m[2], m[0]));  // of the pressed y axis
    for (std::size_t v = 0; v < s.positions.size(); ++v) {
      if (std::abs(s.normals[v].y) < 0.05f) continue;  // their normal lies in the plane and is lost
      EXPECT_GT(glm::dot(s.out_normals[v], winding) * s.normals[v].y, 0.0f) << v;
    }
  }
}

/// Normals of one matrix, which two and four influences of equal weight blend without rounding.
void expect_outward_normals(Way way, const Mat3<float>& joint) {
  test::FixedRandom random(16);
  for (const std::uint32_t count : {1u, 2u, 4u}) {
    auto s = sphere(random, std::span(&count, 1));
    s.influences.weights.assign(s.influences.weights.size(), 1.0f / static_cast<float>(count));
    for (JointMatrix& m : s.palette) m = joint_matrix_from(affine_from(joint, glm::vec3(0)));
    skin(way, s, s.positions);
    RigidStretch split;
    EXPECT_EQ(run(SplitPaletteJob{std::span(s.palette).first(1), std::span(&split, 1)}), ErrorCode::ok);
    const Mat3<double> stretch(matrix_from_stretch(split.stretch));
    const bool by_matrix = way == Way::linear_cofactor || (way == Way::center_of_rotation && count == 1);
    for (std::size_t v = 0; v < s.positions.size(); ++v) {
      const Vec3d n(s.normals[v]), found(s.out_normals[v]), truth = transform_normal_outward(Mat3<double>(joint), n);
      const Vec3d by_stretch = rotate_vector(quat_cast<double>(split.rigid.real), transform_normal_outward(stretch, n));
      EXPECT_TRUE(test::is_near(found, by_matrix ? truth : by_stretch, 2e-6)) << count << ' ' << v;
      EXPECT_GT(glm::dot(found, truth), 0.9) << count << ' ' << v;
    }
  }
}

TEST_P(ExactNormals, G48_normals_of_ill_conditioned_joints_keep_to_the_outside_on_every_instruction_set) {
  for (const std::int64_t target : test::simd_targets()) {
    const test::OnlyTarget only(target);
    test::FixedRandom random(17);
    for (int i = 0; i < 40; ++i) {
      Mat3<double> values(0.0);
      values[0][0] = 1e3;
      values[1][1] = i % 2 ? 1e-3 : -1e-3;
      values[2][2] = i < 20 ? 1e-3 : 4e-2;
      const Mat3<float> joint(matrix_from_unit_quat(random.rotation<double>()) * values *
                              matrix_from_unit_quat(random.rotation<double>()));
      SCOPED_TRACE(test::simd_name(target) + ' ' + std::to_string(i));
      expect_outward_normals(GetParam(), joint);
    }
  }
}

TEST_P(NormalPolicy, N22_collapsed_joints_keep_the_rest_normal_but_for_the_rotation) {
  test::FixedRandom random(15);
  auto s = sphere(random, kSphereCounts);
  for (JointMatrix& m : s.palette) m = joint_matrix_from(affine_from(Mat3<float>(0.0f), {1, 2, 3}));
  skin(GetParam(), s, s.positions);
  for (std::size_t v = 0; v < s.positions.size(); ++v) {
    EXPECT_NEAR(glm::length(s.out_normals[v]), 1.0f, 1e-6f) << v;
    EXPECT_NEAR(glm::length(glm::vec3(s.out_tangents[v])), 1.0f, 1e-6f) << v;
    EXPECT_TRUE(test::is_near(s.out_positions[v], glm::vec3(1, 2, 3), 1e-6)) << v;
  }
}

INSTANTIATE_TEST_SUITE_P(ways, ExactNormals, testing::ValuesIn(test::kWays + 1, std::end(test::kWays)),
                         testing::PrintToStringParamName());
INSTANTIATE_TEST_SUITE_P(ways, NormalPolicy, testing::ValuesIn(test::kWays), testing::PrintToStringParamName());

}  // namespace
}  // namespace sinew
