// SPDX-License-Identifier: MIT
#include "tests/reference/quaternion_normal.h"

#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew::reference {
namespace {

using test::FixedRandom;
using test::is_near;
using test::kEps;

TEST(quaternion_normal, ends_are_the_normals_and_all_between_are_unit) {
  FixedRandom random(1);
  for (int i = 0; i < 500; ++i) {
    const auto a = random.direction(), b = random.direction();
    const auto ha = half_way_from_normal(a), hb = half_way_from_normal(b);
    EXPECT_TRUE(is_near(normal_between(ha, hb, 0.f), a, 16 * kEps));
    EXPECT_TRUE(is_near(normal_between(ha, hb, 1.f), b, 16 * kEps));
    EXPECT_NEAR(safe_length(normal_between(ha, hb, 0.3f)), 1, 12 * kEps);
  }
}

TEST(quaternion_normal, N35_pole_opposite_to_the_axis_gives_a_unit_normal) {
  for (const float x : {0.f, 1e-30f, 1e-20f, 1e-10f, 1e-4f}) {
    const Vec3<float> n(x, 0, -1);
    const auto h = half_way_from_normal(n);
    EXPECT_NEAR(safe_length(h), 1, 4 * kEps) << x;
    EXPECT_TRUE(is_near(normal_between(h, h, 0.5f), Vec3<float>(x, 0, -1), 8 * kEps)) << x;
  }
}

TEST(quaternion_normal, N35_edges_across_the_pole_need_the_alignment) {
  const Vec3<float> a(0.5f, 0, -std::sqrt(0.75f)), b(-0.5f, 0, -std::sqrt(0.75f)), pole(0, 0, -1);
  const auto ha = half_way_from_normal(a), hb = half_way_from_normal(b);
  const auto wrong = normal_between(ha, hb, 0.5f), right = normal_between(ha, half_way_aligned(ha, hb), 0.5f);
  EXPECT_GT(std::acos(glm::dot(wrong, pole)), 1.5f);
  EXPECT_LT(test::distance(right, pole), 1e-6);
}

}  // namespace
}  // namespace sinew::reference
