// SPDX-License-Identifier: MIT
// Joints whose rotations are half a turn apart but for a rounding: the dot product of their quaternions is nearly zero,
// and its sign decides on which side each vertex goes round (N17).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "runtime/deform/skin_center_of_rotation.h"
#include "runtime/deform/skin_dual_quaternion.h"
#include "tests/reference/skinning.h"
#include "tests/support/near.h"
#include "tests/support/simd_targets.h"
#include "tests/support/skinned_vertices.h"

namespace sinew {
namespace {

constexpr std::uint16_t kNearJoints = 24;
constexpr std::uint32_t kNearCounts[] = {2, 3, 4, 5, 8, 12};

/// Vertices whose heaviest influence is joint 0, and rigid joints whose quaternions have these dot products with its
/// own,
/// in turns.
struct NearlyOpposite {
  test::SkinnedVertices vertices;
  std::vector<RigidStretch> split{kNearJoints};
  std::vector<glm::vec3> centers;

  /// in   first  the rotation of joint 0; where it is the identity, dot products are exact in any order of their sum
  NearlyOpposite(std::uint64_t seed, std::uint32_t group_size, const Quat<float>& first, std::vector<double> dots) {
    test::FixedRandom random(seed);
    vertices = test::random_skinned_vertices(random, kNearCounts, group_size, kNearJoints, false);
    for (const InfluenceGroup& group : vertices.influences.groups)
      for (std::uint32_t v = 0; v < group.vertex_count; ++v) lead_with_joint_0(group, v);
    for (std::uint16_t j = 0; j < kNearJoints; ++j) {
      const double dot = dots[j % dots.size()];
      const glm::dvec3 axis = std::sqrt(1.0 - dot * dot) * glm::dvec3(random.direction());
      const Quat<double> turn = quat_xyzw(axis.x, axis.y, axis.z, dot);
      place(random, j, j == 0 ? first : quat_cast<float>(quat_cast<double>(first) * turn));
    }
    for (const glm::vec3& p : vertices.positions) centers.push_back(p + random.vec3());
  }

  void place(test::FixedRandom& random, std::uint16_t j, const Quat<float>& rotation) {
    split[j].rigid = dual_quat_from(rotation, random.vec3());
    vertices.palette[j] = joint_matrix_from(affine_from_dual_quat(split[j].rigid));
  }

  void flip(std::uint16_t j) { split[j].rigid = {-split[j].rigid.real, -split[j].rigid.dual}; }

 private:
  void lead_with_joint_0(const InfluenceGroup& group, std::uint32_t v) {
    const auto joints =
        std::span(vertices.influences.joints)
            .subspan(group.first_influence + std::size_t{v} * group.influence_count, group.influence_count);
    const auto other = std::find(joints.begin(), joints.end(), 0);
    if (other != joints.end()) *other = joints[0];
    joints[0] = 0;
  }
};

/// Joint 0, which is the pivot of every vertex, with each other one.
std::vector<JointPair> every_pair() {
  std::vector<JointPair> pairs;
  for (std::uint16_t j = 1; j < kNearJoints; ++j) pairs.push_back({0, j});
  return pairs;
}

enum class Kind { dual_quaternion, center_of_rotation };

void skin(NearlyOpposite& s, Kind kind, std::span<const JointPair> pairs) {
  if (kind == Kind::dual_quaternion)
    EXPECT_EQ(run(SkinDualQuaternionJob{.influences = &s.vertices.influences,
                                        .split = s.split,
                                        .any_stretch = false,
                                        .vertices = s.vertices.in(),
                                        .out = s.vertices.out(),
                                        .pairs = pairs}),
              ErrorCode::ok);
  else
    EXPECT_EQ(run(SkinCenterOfRotationJob{.influences = &s.vertices.influences,
                                          .palette = s.vertices.palette,
                                          .split = s.split,
                                          .any_stretch = false,
                                          .centers = s.centers,
                                          .vertices = s.vertices.in(),
                                          .out = s.vertices.out(),
                                          .pairs = pairs}),
              ErrorCode::ok);
}

reference::SkinnedT<double> truth(const NearlyOpposite& s, Kind kind, std::size_t v) {
  std::vector<DualQuatd> motions;
  std::vector<Affined> matrices;
  std::vector<double> weights;
  for (const auto j : s.vertices.joints_of(v)) {
    motions.push_back({quat_cast<double>(s.split[j].rigid.real), quat_cast<double>(s.split[j].rigid.dual)});
    matrices.push_back(affine_cast<double>(affine_from(s.vertices.palette[j])));
  }
  for (const float w : s.vertices.weights_of(v)) weights.push_back(double{w});
  const Vec3<double> p(s.vertices.positions[v]), n(s.vertices.normals[v]);
  if (kind == Kind::dual_quaternion) return reference::skin_dual_quaternion<double>(motions, {}, weights, p, n);
  return reference::skin_center_of_rotation<double>(motions, matrices, weights, p, n, Vec3<double>(s.centers[v]));
}

/// The largest distance of a position or normal from double precision.
double farthest_from_truth(const NearlyOpposite& s, Kind kind) {
  double farthest = 0.0;
  for (std::size_t v = 0; v < s.vertices.positions.size(); ++v) {
    const auto expected = truth(s, kind, v);
    farthest = std::max({farthest, test::distance(Vec3<double>(s.vertices.out_positions[v]), expected.position),
                         test::distance(Vec3<double>(s.vertices.out_normals[v]), expected.normal)});
  }
  return farthest;
}

struct Case {
  Kind kind;
  std::int64_t target;
};

std::string name_of(const Case& c) {
  return std::string(c.kind == Kind::dual_quaternion ? "dual_quaternion_" : "center_of_rotation_") +
         test::simd_name(c.target);
}

void PrintTo(const Case& c, std::ostream* out) { *out << name_of(c); }

class near_hemisphere : public ::testing::TestWithParam<Case> {
 protected:
  Kind kind_ = GetParam().kind;
  test::OnlyTarget only_{GetParam().target};
};

const std::vector<std::vector<double>> kDots = {{1e-7},   {-1e-7},          {1e-7, -1e-7},     {0.0, -1e-7}, {0.9e-5},
                                                {1.1e-5}, {1.1e-5, 0.9e-5}, {1.1e-5, -1.1e-5}, {2e-5, -1e-7}};

TEST_P(near_hemisphere, N17_the_sign_of_a_dot_product_of_1e_7_decides_as_in_double_with_and_without_known_pairs) {
  const auto pairs = every_pair();
  for (std::size_t i = 0; i < kDots.size(); ++i)
    for (const std::uint32_t group_size : {3u, 40u}) {
      NearlyOpposite s(i + 1, group_size, quat_identity<float>(), kDots[i]);
      skin(s, kind_, {});
      EXPECT_LT(farthest_from_truth(s, kind_), 2e-5) << i;
      const auto positions = s.vertices.out_positions, normals = s.vertices.out_normals;
      skin(s, kind_, pairs);
      EXPECT_TRUE(positions == s.vertices.out_positions && normals == s.vertices.out_normals) << i;
    }
}

TEST_P(near_hemisphere, N17_sums_of_four_products_that_nearly_cancel_decide_alike_with_and_without_known_pairs) {
  test::FixedRandom random(77);
  const auto pairs = every_pair();
  for (const double dot : {0.0, 3e-8, -3e-8, 1e-6, -1e-6})
    for (const double other : {dot, -dot, 0.5}) {
      NearlyOpposite s(random.below(1000), 20, quat_cast<float>(random.rotation<double>()), {dot, other});
      skin(s, kind_, {});
      EXPECT_TRUE(std::abs(dot) < 5e-7 || farthest_from_truth(s, kind_) < 2e-5) << dot;
      const auto positions = s.vertices.out_positions, normals = s.vertices.out_normals;
      skin(s, kind_, pairs);
      EXPECT_TRUE(positions == s.vertices.out_positions && normals == s.vertices.out_normals) << dot;
    }
}

TEST_P(near_hemisphere, N17_a_dot_product_of_minus_zero_is_on_the_side_of_the_pivot) {
  test::FixedRandom random(5);
  NearlyOpposite s(5, 20, quat_identity<float>(), {0.3});
  for (std::uint16_t j = 1; j < kNearJoints; ++j) {
    const glm::vec3 axis = -glm::abs(glm::vec3(random.direction()));
    s.place(random, j, quat_xyzw(axis.x, axis.y, axis.z, -0.0f));
  }
  skin(s, kind_, {});
  EXPECT_LT(farthest_from_truth(s, kind_), 2e-5);
}

// A list that misses pairs is believed where those that it has are clearly on one side, and only there: this tells
// where "clearly" begins.
TEST_P(near_hemisphere, N17_signs_are_compared_vertex_by_vertex_up_to_a_dot_product_of_1e_5) {
  const JointPair listed[] = {{0, 1}};
  for (const double dot : {-1e-7, 1e-7, 0.99e-5, 1.01e-5, 0.5}) {
    NearlyOpposite s(9, 20, quat_identity<float>(), {0.3, dot});   // joint 1 has `dot`, as every second one
    for (std::uint16_t j = 2; j < kNearJoints; j += 2) s.flip(j);  // clearly on the other side, and not listed
    skin(s, kind_, listed);
    EXPECT_EQ(farthest_from_truth(s, kind_) > 0.1, dot > 1e-5) << dot;
  }
}

std::vector<Case> every_case() {
  std::vector<Case> all;
  for (const std::int64_t target : test::simd_targets())
    for (const Kind kind : {Kind::dual_quaternion, Kind::center_of_rotation}) all.push_back({kind, target});
  return all;
}

INSTANTIATE_TEST_SUITE_P(kinds, near_hemisphere, ::testing::ValuesIn(every_case()),
                         [](const auto& test) { return name_of(test.param); });

}  // namespace
}  // namespace sinew
