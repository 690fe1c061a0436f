// SPDX-License-Identifier: MIT
#include "runtime/deform/flat_faces.h"

#include <gtest/gtest.h>

namespace sinew::test {
namespace {

using Indices = std::vector<std::uint32_t>;

TEST(flat_faces, triangles_of_vertices_in_a_row_are_runs) {
  const FlatFaces faces = sort_flat_faces(Indices{3, 4, 5, 0, 2, 1, 6, 7, 8}, 9);
  EXPECT_EQ(faces.runs, (Indices{3, 6}));
  EXPECT_EQ(faces.corners, (Indices{0, 2, 1}));
  EXPECT_TRUE(faces.faceless.empty());
  EXPECT_FALSE(faces.share_vertices);
  EXPECT_EQ(faces.count(), 3u);
}

TEST(flat_faces, the_triangle_of_the_last_vertex_ends_its_list) {
  EXPECT_EQ(sort_flat_faces(Indices{6, 7, 8, 0, 1, 2, 3, 4, 5}, 9).runs, (Indices{0, 3, 6}));
  EXPECT_EQ(sort_flat_faces(Indices{6, 8, 7, 0, 2, 1}, 9).corners, (Indices{0, 2, 1, 6, 8, 7}));
}

TEST(flat_faces, vertices_of_no_triangle_are_listed) {
  EXPECT_EQ(sort_flat_faces(Indices{1, 2, 3}, 6).faceless, (Indices{0, 4, 5}));
  EXPECT_EQ(sort_flat_faces({}, 2).faceless, (Indices{0, 1}));
}

TEST(flat_faces, triangles_that_share_vertices_keep_their_order) {
  const FlatFaces faces = sort_flat_faces(Indices{0, 1, 2, 2, 1, 3}, 4);
  EXPECT_TRUE(faces.share_vertices);
  EXPECT_EQ(faces.corners, (Indices{0, 1, 2, 2, 1, 3}));
  EXPECT_TRUE(faces.runs.empty());
}

}  // namespace
}  // namespace sinew::test
