// SPDX-License-Identifier: MIT
// How far each kind of skinning shrinks or bulges: closed forms for two joints with half the weight each.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/near.h"
#include "tests/support/skinning_ways.h"

namespace sinew {
namespace {

using test::Way;

constexpr double kDegree = 3.141592653589793 / 180;

/// One vertex between a joint at rest and a joint turned about an axis through the origin.
test::SkinnedVertices between(const glm::vec3& p, const glm::vec3& axis, double angle_rad) {
  test::SkinnedVertices s;
  s.positions = {p};
  s.out_positions.resize(1);
  s.influences = {{{0, 1, 2, 0}}, {0, 1}, {0.5f, 0.5f}};
  const Vec3<double> half = Vec3<double>(axis) * std::sin(angle_rad / 2);
  const Transform turned{
      {0, 0, 0}, quat_cast<float>(quat_xyzw(half.x, half.y, half.z, std::cos(angle_rad / 2))), glm::vec3(1)};
  s.palette = {JointMatrix{}, joint_matrix_from(affine_from_transform(turned))};
  return s;
}

glm::vec3 skinned(Way way, test::SkinnedVertices s, const glm::vec3& center) {
  skin(way, s, {&center, 1});
  return s.out_positions[0];
}

TEST(skinning_envelopes, N20_a_twist_shrinks_only_linear_blending_by_cos_of_half_the_angle) {
  const glm::vec3 p(0.25f, 0, 2), on_axis(0.25f, 0, 0), x(1, 0, 0);
  for (const double degrees : {0.0, 30.0, 90.0, 150.0, 179.0}) {
    const auto s = between(p, x, degrees * kDegree);
    const auto radius = [&](Way way) { return glm::length(skinned(way, s, on_axis) - on_axis); };
    EXPECT_NEAR(radius(Way::linear), 2 * std::cos(degrees * kDegree / 2), 1e-6) << degrees;
    EXPECT_NEAR(radius(Way::dual_quaternion), 2, 1e-6) << degrees;
    EXPECT_NEAR(radius(Way::center_of_rotation), 2, 1e-6) << degrees;
  }
}

// A limb along x, bent about z at the origin. The vertex is `along` beyond the joint and `above` the bone; its center
// is on the bone. Linear blending shrinks its distance from the joint. Dual quaternions keep that distance, which
// pushes the skin off the bent bone. Skinning around the center keeps its distance from the bone, while the bone gets
// shorter.
TEST(skinning_envelopes, N20_a_bend_shrinks_bulges_or_keeps_its_distance_by_kind) {
  const glm::vec3 z(0, 0, 1);
  for (const double degrees : {30.0, 90.0, 120.0, 170.0})
    for (const float along : {-0.5f, 0.0f, 0.25f, 1.0f})
      for (const float above : {-0.5f, 0.25f, 1.0f}) {
        const auto s = between({along, above, 0}, z, degrees * kDegree);
        const glm::vec3 on_bone(along, 0, 0);
        const double k = std::cos(degrees * kDegree / 2);
        const double linear = glm::length(skinned(Way::linear, s, on_bone)),
                     dual = glm::length(skinned(Way::dual_quaternion, s, on_bone)),
                     center = glm::length(skinned(Way::center_of_rotation, s, on_bone));
        EXPECT_NEAR(linear, k * std::hypot(along, above), 1e-6);
        EXPECT_NEAR(center, std::hypot(k * static_cast<double>(along), above), 1e-6);
        EXPECT_NEAR(dual, std::hypot(along, above), 1e-6);
        EXPECT_LE(linear, center + 1e-6);
        EXPECT_LE(center, dual + 1e-6);
      }
}

}  // namespace
}  // namespace sinew
