// SPDX-License-Identifier: MIT
// Skinning works on tiles of vertices, whose size depends on the instruction set. The bits must not depend on it.
#include <gtest/gtest.h>

#include <cstring>

#include "tests/support/near.h"
#include "tests/support/simd_targets.h"
#include "tests/support/skinning_ways.h"

namespace sinew {
namespace {

using test::Way;

constexpr std::uint32_t kTileCounts[] = {1, 2, 3, 4, 5, 9};
constexpr std::uint32_t kGroupSizes[] = {1, 3, 4, 5, 9, 15, 16, 17, 18, 19, 33, 50};

struct Skinned {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec4> tangents;

  Skinned(Way way, test::SkinnedVertices& s, std::span<const glm::vec3> centers, std::int64_t target) {
    const test::OnlyTarget only(target);
    test::skin(way, s, centers);
    positions = s.out_positions;
    normals = s.out_normals;
    tangents = s.out_tangents;
  }
  bool same_bits(const Skinned& other) const {
    const auto same = [](const auto& a, const auto& b) {
      return std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
    };
    return same(positions, other.positions) && same(normals, other.normals) && same(tangents, other.tangents);
  }
};

std::int64_t best_target() { return test::simd_targets().front(); }

class SkinTiles : public testing::TestWithParam<Way> {};

TEST_P(SkinTiles, N27_groups_of_every_size_have_the_same_bits_on_every_instruction_set) {
  test::FixedRandom random(31);
  for (const bool with_scale : {false, true})
    for (const std::uint32_t size : kGroupSizes) {
      auto s = test::random_skinned_vertices(random, kTileCounts, size, 24, with_scale);
      const auto centers = s.normals;
      const Skinned expected(GetParam(), s, centers, best_target()),
          unfused(GetParam(), s, centers, test::simd_targets().back());
      for (const std::int64_t target : test::simd_targets()) {
        const Skinned found(GetParam(), s, centers, target);
        EXPECT_TRUE(found.same_bits(test::fuses_multiply_add(target) ? expected : unfused))
            << size << ' ' << test::simd_name(target);
        for (std::size_t v = 0; v < s.positions.size(); ++v)
          ASSERT_TRUE(test::is_near(found.positions[v], expected.positions[v], 1e-4))
              << size << ' ' << v << ' ' << test::simd_name(target);
      }
    }
}

TEST_P(SkinTiles, a_vertex_has_the_bits_that_it_has_alone) {
  test::FixedRandom random(32);
  for (const std::uint32_t size : kGroupSizes) {
    const std::uint32_t four[] = {4};
    auto s = test::random_skinned_vertices(random, four, size, 24, true);
    for (glm::vec4& column : s.palette[5].column)
      column = glm::vec4(0, 0, 0, column.w);  // collapses vertices that mainly follow it
    s.normals[size / 2] = glm::vec3(0);       // a normal without direction
    const auto centers = s.positions;
    const Skinned all(GetParam(), s, centers, best_target());
    for (std::uint32_t v = 0; v < size; ++v) {
      auto alone = s;
      const auto one = [v](auto& values) { values = {values[v]}; };
      one(alone.positions);
      one(alone.normals);
      one(alone.tangents);
      alone.influences = {{{0, 1, 4, 0}},
                          {s.joints_of(v).begin(), s.joints_of(v).end()},
                          {s.weights_of(v).begin(), s.weights_of(v).end()}};
      const Skinned single(GetParam(), alone, std::span(centers).subspan(v, 1), best_target());
      EXPECT_EQ(single.positions[0], all.positions[v]) << size << ' ' << v;
      EXPECT_EQ(single.normals[0], all.normals[v]) << size << ' ' << v;
      EXPECT_EQ(single.tangents[0], all.tangents[v]) << size << ' ' << v;
    }
  }
}

TEST_P(SkinTiles, nothing_is_written_beyond_the_vertices) {
  test::FixedRandom random(33);
  for (const std::uint32_t size : kGroupSizes) {
    auto s = test::random_skinned_vertices(random, kTileCounts, size, 24, false);
    const std::size_t count = s.positions.size();
    s.out_positions.assign(count + 16, glm::vec3(77));
    s.out_normals.assign(count + 16, glm::vec3(77));
    s.out_tangents.assign(count + 16, glm::vec4(77));
    test::skin(GetParam(), s, s.positions);
    for (std::size_t v = count; v < count + 16; ++v) {
      EXPECT_EQ(s.out_positions[v], glm::vec3(77));
      EXPECT_EQ(s.out_normals[v], glm::vec3(77));
      EXPECT_EQ(s.out_tangents[v], glm::vec4(77));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(ways, SkinTiles, testing::ValuesIn(test::kWays));

}  // namespace
}  // namespace sinew
