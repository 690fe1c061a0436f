// SPDX-License-Identifier: MIT
#include "runtime/deform/blend_combinations.h"

#include <gtest/gtest.h>

#include <cstring>

#include "runtime/base/same_bits.h"
#include "runtime/deform/skin_linear.h"
#include "tests/support/near.h"
#include "tests/support/simd_targets.h"
#include "tests/support/skinned_vertices.h"

namespace sinew {
namespace {

constexpr std::uint32_t kBlendedCounts[] = {1, 2, 3, 4, 5, 9};

TEST(blend_combinations, rejects_wrong_sizes_and_joints_out_of_range) {
  test::FixedRandom random(1);
  const auto s = test::random_skinned_vertices(random, kBlendedCounts, 3, 24, true);
  std::vector<JointMatrix> blended(s.positions.size());
  EXPECT_EQ(check(BlendCombinationsJob{&s.influences, s.palette, blended}), ErrorCode::ok);
  EXPECT_EQ(check(BlendCombinationsJob{nullptr, s.palette, blended}), ErrorCode::size_mismatch);
  EXPECT_EQ(check(BlendCombinationsJob{&s.influences, s.palette, std::span(blended).first(2)}),
            ErrorCode::size_mismatch);
  EXPECT_EQ(check(BlendCombinationsJob{&s.influences, std::span(s.palette).first(3), blended}),
            ErrorCode::index_out_of_range);
}

TEST(blend_combinations, C06_is_the_weighted_sum_of_the_matrices) {
  test::FixedRandom random(2);
  const auto s = test::random_skinned_vertices(random, kBlendedCounts, 7, 24, true);
  for (const std::int64_t target : test::simd_targets()) {
    const test::OnlyTarget only(target);
    std::vector<JointMatrix> blended(s.positions.size());
    EXPECT_EQ(run(BlendCombinationsJob{&s.influences, s.palette, blended}), ErrorCode::ok);
    for (const InfluenceGroup& group : s.influences.groups)
      for (std::size_t k = 0; k < group.vertex_count; ++k)
        for (int c = 0; c < 4; ++c) {
          Vec4<double> sum(0.0);
          for (std::size_t i = 0; i < group.influence_count; ++i) {
            const std::size_t at = group.first_influence + k * group.influence_count + i;
            sum += Vec4<double>(s.palette[s.influences.joints[at]].column[c]) *
                   static_cast<double>(s.influences.weights[at]);
          }
          for (int r = 0; r < 4; ++r)
            ASSERT_NEAR(static_cast<double>(blended[group.first_vertex + k].column[c][r]), sum[r],
                        2e-6 * (1.0 + glm::length(sum)));
        }
  }
}

TEST(blend_combinations, C06_vertices_that_follow_them_have_the_bits_of_those_that_blend_for_themselves) {
  test::FixedRandom random(3);
  const auto s = test::random_skinned_vertices(random, kBlendedCounts, 19, 24, true);
  const std::size_t count = s.positions.size();
  VertexInfluences follow;
  follow.groups = {{0, static_cast<std::uint32_t>(count), 1, 0}};
  for (std::size_t v = 0; v < count; ++v) {
    follow.joints.push_back(static_cast<std::uint16_t>(v));
    follow.weights.push_back(1.0f);
  }
  for (const std::int64_t target : test::simd_targets()) {
    const test::OnlyTarget only(target);
    std::vector<JointMatrix> blended(count);
    EXPECT_EQ(run(BlendCombinationsJob{&s.influences, s.palette, blended}), ErrorCode::ok);
    std::vector<glm::vec3> expected(count), found(count);
    EXPECT_EQ(
        run(SkinLinearJob{&s.influences, s.palette, {s.positions, {}, {}}, {expected, {}, {}}, NormalRule::linear}),
        ErrorCode::ok);
    EXPECT_EQ(run(SkinLinearJob{&follow, blended, {s.positions, {}, {}}, {found, {}, {}}, NormalRule::linear}),
              ErrorCode::ok);
    EXPECT_TRUE(same_bits<glm::vec3>(expected, found)) << test::simd_name(target);
  }
}

}  // namespace
}  // namespace sinew
