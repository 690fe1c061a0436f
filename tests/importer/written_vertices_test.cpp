// SPDX-License-Identifier: MIT
// Files are written in the vertex order of the primitive's original file, if all copies of a vertex are equal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "importer/write/file_vertices.h"

namespace sinew::test {
namespace {

using testing::ElementsAre;

Primitive primitive_from(std::vector<std::uint32_t> source_vertex) {
  Primitive primitive;
  primitive.positions.resize(source_vertex.size());
  primitive.source_vertex = std::move(source_vertex);
  return primitive;
}

TEST(written_vertices, go_back_to_the_order_of_the_file) {
  const auto order = write::file_vertices(primitive_from({2, 0, 1}));
  EXPECT_THAT(order.scene_vertex, ElementsAre(1, 2, 0));
  EXPECT_THAT(order.file_vertex, ElementsAre(2, 0, 1));
}

TEST(written_vertices, of_copies_for_flat_normals_the_first_is_written) {
  Primitive primitive = primitive_from({1, 0, 1, 0});
  primitive.flat_normals = true;
  const auto order = write::file_vertices(primitive);
  EXPECT_THAT(order.scene_vertex, ElementsAre(1, 0));
  EXPECT_THAT(order.file_vertex, ElementsAre(1, 0, 1, 0));
}

TEST(written_vertices, keep_the_order_of_the_scene_where_copies_may_differ) {
  Primitive smooth = primitive_from({1, 0, 1, 0});
  EXPECT_THAT(write::file_vertices(smooth).scene_vertex, ElementsAre(0, 1, 2, 3))
      << "each copy has a normal of its own";
  smooth.flat_normals = true;
  smooth.tangents.resize(4);
  EXPECT_THAT(write::file_vertices(smooth).scene_vertex, ElementsAre(0, 1, 2, 3))
      << "each copy has a tangent of its own";
}

TEST(written_vertices, keep_the_order_of_the_scene_where_that_of_the_file_has_gaps_or_is_not_known) {
  for (const auto& source : {std::vector<std::uint32_t>{0, 2, 2}, {0, 1, 3}, {4, 1, 2}}) {
    Primitive primitive = primitive_from(source);
    primitive.flat_normals = true;
    EXPECT_THAT(write::file_vertices(primitive).scene_vertex, ElementsAre(0, 1, 2));
    EXPECT_THAT(write::file_vertices(primitive).file_vertex, ElementsAre(0, 1, 2));
  }
  Primitive unknown = primitive_from({});
  unknown.positions.resize(2);
  EXPECT_THAT(write::file_vertices(unknown).scene_vertex, ElementsAre(0, 1));
}

}  // namespace
}  // namespace sinew::test
