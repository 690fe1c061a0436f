// SPDX-License-Identifier: MIT
#include "importer/topology/adjacency.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/importer/tiny_surfaces.h"
#include "tests/support/fixed_random.h"

namespace sinew {
namespace {

using testing::Each;
using testing::ElementsAre;

TEST(adjacency, of_two_triangles_joins_them_over_their_edge) {
  const auto a = make_adjacency(std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}, 4);
  EXPECT_THAT(a.corner_vertex, ElementsAre(0, 1, 2, 0, 2, 3));
  EXPECT_THAT(a.source, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(a.neighbour, ElementsAre(kNone, kNone, 1, 0, kNone, kNone));
}

TEST(adjacency, of_a_closed_surface_has_no_border) {
  const Primitive cube = test::cube();
  const auto a = make_adjacency(cube.indices, 8);
  EXPECT_EQ(a.source.size(), 8u);
  EXPECT_THAT(a.neighbour, Each(testing::Ne(kNone)));
}

TEST(adjacency, parts_fans_that_touch_in_one_vertex) {
  const auto a = make_adjacency(std::vector<std::uint32_t>{0, 1, 2, 0, 3, 4}, 5);
  EXPECT_EQ(a.source.size(), 6u);
  EXPECT_NE(a.corner_vertex[0], a.corner_vertex[3]);
  EXPECT_EQ(a.source[a.corner_vertex[3]], 0u);
  EXPECT_THAT(a.neighbour, Each(kNone));
}

TEST(adjacency, cuts_an_edge_of_three_faces) {
  const auto a = make_adjacency(std::vector<std::uint32_t>{0, 1, 2, 1, 0, 3, 0, 1, 4}, 5);
  EXPECT_THAT(a.neighbour, Each(kNone));
  EXPECT_EQ(a.source.size(), 9u);
}

TEST(adjacency, cuts_an_edge_between_faces_that_wind_against_each_other) {
  const auto a = make_adjacency(std::vector<std::uint32_t>{0, 1, 2, 0, 1, 3}, 4);
  EXPECT_THAT(a.neighbour, Each(kNone));
}

TEST(adjacency, leaves_out_faces_with_repeated_vertices) {
  const auto a = make_adjacency(std::vector<std::uint32_t>{0, 0, 1, 0, 1, 2}, 3);
  EXPECT_THAT(a.corner_vertex, ElementsAre(kNone, kNone, kNone, 0, 1, 2));
  EXPECT_THAT(a.neighbour, Each(kNone));
}

TEST(adjacency, of_a_face_and_its_back_is_closed) {
  const auto a = make_adjacency(std::vector<std::uint32_t>{0, 1, 2, 0, 2, 1}, 3);
  EXPECT_EQ(a.source.size(), 3u);
  EXPECT_THAT(a.neighbour, ElementsAre(1, 1, 1, 0, 0, 0));
}

TEST(adjacency, of_nothing_is_empty) {
  EXPECT_EQ(make_adjacency({}, 0).face_count(), 0u);
  EXPECT_TRUE(make_adjacency({}, 5).source.empty());
}

/// Random faces over few vertices: nearly every edge and vertex is non-manifold.
TEST(adjacency, of_random_triangle_soup_is_a_manifold_that_leads_back_to_its_source) {
  test::FixedRandom random(11);
  for (int round = 0; round < 400; ++round) {
    const std::uint32_t vertex_count = 3 + random.below(12);
    std::vector<std::uint32_t> triangles(3 * (1 + random.below(60)));
    for (auto& v : triangles) v = random.below(vertex_count);
    const auto a = make_adjacency(triangles, vertex_count);
    for (std::size_t c = 0; c < triangles.size(); ++c) {
      const std::size_t f = c / 3, end = c % 3 == 2 ? c - 2 : c + 1;
      if (a.corner_vertex[c] == kNone) {
        const auto* t = &triangles[3 * f];
        ASSERT_TRUE(t[0] == t[1] || t[1] == t[2] || t[2] == t[0]);
        continue;
      }
      ASSERT_EQ(a.source[a.corner_vertex[c]], triangles[c]);
      const std::uint32_t g = a.neighbour[c];
      if (g == kNone) continue;
      ASSERT_NE(g, f);
      int back = 0;  // the neighbour has the edge once, in opposite order, and points back
      for (std::size_t d = 3 * std::size_t{g}; d < 3 * std::size_t{g} + 3; ++d) {
        const std::size_t d_end = d % 3 == 2 ? d - 2 : d + 1;
        back += a.corner_vertex[d] == a.corner_vertex[end] && a.corner_vertex[d_end] == a.corner_vertex[c] &&
                a.neighbour[d] == f;
      }
      ASSERT_EQ(back, 1);
    }
  }
}

TEST(adjacency, joins_every_edge_that_a_plain_search_finds_shared_by_two_opposite_faces) {
  test::FixedRandom random(12);
  for (int round = 0; round < 200; ++round) {
    std::vector<std::uint32_t> triangles;
    while (triangles.size() < 60) {
      const std::uint32_t a = random.below(14), b = random.below(14), c = random.below(14);
      if (a != b && b != c && c != a) triangles.insert(triangles.end(), {a, b, c});
    }
    const auto result = make_adjacency(triangles, 14);
    const auto ends = [&](std::size_t c) { return std::pair(triangles[c], triangles[c % 3 == 2 ? c - 2 : c + 1]); };
    for (std::size_t c = 0; c < triangles.size(); ++c) {
      std::size_t same = 0, opposite = 0, face = 0;
      for (std::size_t d = 0; d < triangles.size(); ++d) {
        same += ends(d) == ends(c);
        if (ends(d) == std::pair(ends(c).second, ends(c).first)) {
          ++opposite;
          face = d / 3;
        }
      }
      if (same == 1 && opposite == 1) {
        ASSERT_EQ(result.neighbour[c], face);
      }
    }
  }
}

}  // namespace
}  // namespace sinew
