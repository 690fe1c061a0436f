// SPDX-License-Identifier: MIT
#include "runtime/deform/flat_faces.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sinew::test {
namespace {

using Indices = std::vector<std::uint32_t>;

/// Triangle t has vertices first[c] + t.
Indices stream(std::array<std::uint32_t, 3> first, std::uint32_t count) {
  Indices triangles;
  for (std::uint32_t t = 0; t < count; ++t)
    for (const std::uint32_t vertex : first) triangles.push_back(vertex + t);
  return triangles;
}

TEST(flat_faces, triangles_whose_corners_follow_each_other_are_a_stream) {
  Indices triangles = stream({40, 0, 20}, 20);
  std::rotate(triangles.begin(), triangles.begin() + 21, triangles.end());  // the order of triangles must not matter
  const FlatFaces faces = sort_flat_faces(triangles, 60);
  ASSERT_EQ(faces.streams.size(), 1u);
  EXPECT_EQ(faces.streams[0].first, (std::array<std::uint32_t, 3>{40, 0, 20}));
  EXPECT_EQ(faces.streams[0].count, 20u);
  EXPECT_TRUE(faces.corners.empty());
  EXPECT_TRUE(faces.alone.empty());
  EXPECT_TRUE(faces.at_rest.empty());
  EXPECT_EQ(faces.count, 20u);
}

TEST(flat_faces, every_corner_must_follow) {
  for (std::size_t other : {0, 1, 2}) {
    std::array<std::uint32_t, 3> next = {16, 56, 96};
    next[other] += 120;
    Indices triangles = stream({0, 40, 80}, 16);
    const Indices more = stream(next, 16);
    triangles.insert(triangles.end(), more.begin(), more.end());
    EXPECT_EQ(sort_flat_faces(triangles, 240).streams.size(), 2u) << other;
  }
}

TEST(flat_faces, a_stream_fills_the_widest_vectors) {
  EXPECT_EQ(sort_flat_faces(stream({0, 16, 32}, 16), 49).streams.size(), 1u);
  const FlatFaces few = sort_flat_faces(stream({0, 16, 32}, 15), 49);
  EXPECT_TRUE(few.streams.empty());
  EXPECT_EQ(few.count, 15u);
}

TEST(flat_faces, other_triangles_fill_the_widest_vectors_by_repetition) {
  Indices expected = stream({0, 16, 32}, 15);
  expected.insert(expected.end(), {0, 16, 32});
  EXPECT_EQ(sort_flat_faces(stream({0, 16, 32}, 15), 49).corners, expected);
}

TEST(flat_faces, the_triangle_of_the_last_vertex_is_alone_where_it_is_in_no_stream) {
  for (const Indices& triangles : {Indices{0, 8, 7, 3, 2, 1}, Indices{8, 0, 7, 3, 2, 1}, Indices{3, 2, 1, 7, 0, 8}}) {
    const FlatFaces faces = sort_flat_faces(triangles, 9);
    EXPECT_EQ(faces.alone.size(), 3u);
    EXPECT_EQ(std::count(faces.alone.begin(), faces.alone.end(), 8u), 1);
    EXPECT_EQ(std::count(faces.corners.begin(), faces.corners.end(), 8u), 0);
    EXPECT_EQ(std::count(faces.corners.begin(), faces.corners.end(), 3u), 16);
    EXPECT_EQ(faces.at_rest, (Indices{0, 4, 5, 6, 7, 8})) << "those of no triangle, too";
    EXPECT_EQ(faces.count, 2u);
  }
  EXPECT_TRUE(sort_flat_faces(stream({0, 16, 32}, 16), 48).alone.empty());
}

TEST(flat_faces, triangles_that_share_vertices_keep_their_order) {
  const FlatFaces faces = sort_flat_faces(Indices{0, 1, 2, 2, 1, 3}, 5);
  EXPECT_EQ(faces.alone, (Indices{0, 1, 2, 2, 1, 3}));
  EXPECT_EQ(faces.at_rest, (Indices{0, 1, 2, 3, 4}));
  EXPECT_TRUE(faces.streams.empty());
  EXPECT_TRUE(faces.corners.empty());
  EXPECT_EQ(sort_flat_faces({}, 2).at_rest, (Indices{0, 1}));
}

}  // namespace
}  // namespace sinew::test
