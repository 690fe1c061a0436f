// SPDX-License-Identifier: MIT
// Consecutive vertices with the same joints take special code paths, which must give the same bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <span>
#include <vector>

#include "runtime/base/same_bits.h"
#include "tests/support/simd_targets.h"
#include "tests/support/skinning_ways.h"

namespace sinew {
namespace {

using test::FixedRandom;
using test::SkinnedVertices;
using test::Way;

constexpr std::uint32_t kRunCounts[] = {1, 2, 3, 4, 5, 8};
constexpr std::uint32_t kRunLengths[] = {1, 5, 15, 16, 17, 20, 31, 33, 70, 16, 2, 40, 64, 3};

/// Runs of vertices with the same joints but different weights. Joint 1 collapses, joint 2 flattens, joint 3 mirrors;
/// in every other run all influences name one joint. Some normals are zero, or have lengths whose square leaves float's
/// range.
SkinnedVertices runs_of_joints(FixedRandom& random, std::uint32_t influence_count) {
  const std::uint32_t count = std::accumulate(std::begin(kRunLengths), std::end(kRunLengths), 0u);
  SkinnedVertices s = test::random_skinned_vertices(random, std::span(&influence_count, 1), count, 8, true);
  auto joint = s.influences.joints.begin();
  for (std::uint32_t run = 0; run < std::size(kRunLengths); ++run)
    for (std::uint32_t v = 0; v < kRunLengths[run]; ++v)
      for (std::uint32_t i = 0; i < influence_count; ++i)
        *joint++ = static_cast<std::uint16_t>((run + (run % 2 == 0 ? i : 0)) % 8);
  for (glm::vec4& column : s.palette[1].column) column = glm::vec4(0, 0, 0, column.w);
  s.palette[2].column[1] = s.palette[2].column[0];
  s.palette[3].column[0] = -s.palette[3].column[0];
  for (std::size_t v = 3; v < count; v += 19) s.normals[v] *= v % 2 == 0 ? 0.0f : 1e18f;
  return s;
}

/// The vertices of `s` in another order; all have equally many influences.
SkinnedVertices reordered(const SkinnedVertices& s, std::span<const std::uint32_t> order) {
  SkinnedVertices out = s;
  const std::uint32_t influences = s.influences.groups[0].influence_count;
  for (std::size_t v = 0; v < order.size(); ++v) {
    out.positions[v] = s.positions[order[v]];
    if (!s.normals.empty()) out.normals[v] = s.normals[order[v]];
    if (!s.tangents.empty()) out.tangents[v] = s.tangents[order[v]];
    std::copy_n(&s.influences.joints[order[v] * influences], influences, &out.influences.joints[v * influences]);
    std::copy_n(&s.influences.weights[order[v] * influences], influences, &out.influences.weights[v * influences]);
  }
  return out;
}

std::vector<std::uint32_t> shuffled(FixedRandom& random, std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
  return order;
}

class JointRuns : public testing::TestWithParam<Way> {
 protected:
  /// Skins the vertices in runs and in random order.
  static void expect_same_bits(SkinnedVertices s, FixedRandom& random) {
    const std::vector<std::uint32_t> order = shuffled(random, s.positions.size());
    SkinnedVertices other = reordered(s, order);
    test::skin(GetParam(), s, s.positions);
    test::skin(GetParam(), other, other.positions);
    for (std::size_t v = 0; v < order.size(); ++v) {
      const std::uint32_t joint = other.joints_of(v)[0];
      ASSERT_TRUE(same_bits(other.out_positions[v], s.out_positions[order[v]])) << "joint " << joint;
      ASSERT_TRUE(same_bits(other.out_normals[v], s.out_normals[order[v]])) << "joint " << joint;
      ASSERT_TRUE(same_bits(other.out_tangents[v], s.out_tangents[order[v]])) << "joint " << joint;
    }
  }
};

TEST_P(JointRuns, have_the_bits_of_vertices_in_any_order) {
  FixedRandom random(51);
  for (const std::int64_t target : test::simd_targets())
    for (const std::uint32_t count : kRunCounts) {
      const test::OnlyTarget only(target);
      SCOPED_TRACE(testing::Message() << test::simd_name(target) << ", influences " << count);
      SkinnedVertices s = runs_of_joints(random, count);
      expect_same_bits(s, random);
      s.tangents.clear();
      expect_same_bits(s, random);
      s.normals.clear();
      expect_same_bits(s, random);
    }
}

TEST_P(JointRuns, write_nothing_beyond_their_vertices) {
  FixedRandom random(52);
  for (const std::int64_t target : test::simd_targets())
    for (const std::uint32_t count : kRunCounts) {
      const test::OnlyTarget only(target);
      for (const std::uint32_t size : {16, 17, 24, 32, 35}) {
        SkinnedVertices s = test::random_skinned_vertices(random, std::span(&count, 1), size, 8, false);
        for (std::size_t i = 0; i < s.influences.joints.size(); ++i)
          s.influences.joints[i] = static_cast<std::uint16_t>(i % count);
        s.out_positions.assign(size + 16, glm::vec3(77));
        s.out_normals.assign(size + 16, glm::vec3(77));
        s.out_tangents.assign(size + 16, glm::vec4(77));
        test::skin(GetParam(), s, s.positions);
        for (std::size_t v = 0; v < size + 16; ++v) {
          EXPECT_EQ(s.out_positions[v] == glm::vec3(77), v >= size) << size << ' ' << v;
          EXPECT_EQ(s.out_normals[v] == glm::vec3(77), v >= size) << size << ' ' << v;
          EXPECT_EQ(s.out_tangents[v] == glm::vec4(77), v >= size) << size << ' ' << v;
        }
      }
    }
}

INSTANTIATE_TEST_SUITE_P(ways, JointRuns, testing::ValuesIn(test::kWays));

}  // namespace
}  // namespace sinew
