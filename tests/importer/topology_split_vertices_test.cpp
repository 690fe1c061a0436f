// SPDX-License-Identifier: MIT
#include "importer/topology/split_vertices.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/importer/tiny_surfaces.h"

namespace sinew {
namespace {

using testing::ElementsAre;

/// Two triangles over four vertices with every attribute, two influence groups, and one morph target.
Primitive rich_primitive() {
  Primitive p = test::upright_square();
  p.tangents = {{1, 0, 0, 1}, {1, 0, 0, -1}, {0, 1, 0, 1}, {0, 1, 0, -1}};
  p.colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 1}};
  p.influences.groups = {{0, 3, 2, 0}, {3, 1, 1, 6}};
  p.influences.joints = {10, 11, 20, 21, 30, 31, 40};
  p.influences.weights = {0.9f, 0.1f, 0.8f, 0.2f, 0.7f, 0.3f, 1.0f};
  MorphTarget target;
  target.positions = {{0, 2}, {{1, 2, 3}, {4, 5, 6}}};
  target.normals = {{2}, {{7, 8, 9}}};
  target.tangents = {{0}, {{1, 1, 1}}};
  target.colors = {{3}, {{0.5f, 0, 0, 0}}};
  target.texcoords = {{{2}, {{0.25f, 0.75f}}}};
  p.morphs.targets = {target};
  return p;
}

TEST(split_vertices, carries_every_attribute_to_the_copies) {
  Primitive p = rich_primitive();
  const Primitive before = p;
  split_vertices(p, std::vector<std::uint32_t>{5, 5, 5, 6, 6, 6});  // vertices 0 and 2 are in both faces

  EXPECT_THAT(p.indices, ElementsAre(0, 2, 3, 1, 4, 5));
  EXPECT_THAT(p.source_vertex, ElementsAre(0, 0, 1, 2, 2, 3));
  for (std::size_t v = 0; v < 6; ++v) {
    const std::size_t s = p.source_vertex[v];
    EXPECT_EQ(p.positions[v], before.positions[s]);
    EXPECT_EQ(p.normals[v], before.normals[s]);
    EXPECT_EQ(p.tangents[v], before.tangents[s]);
    EXPECT_EQ(p.texcoords[0][v], before.texcoords[0][s]);
    EXPECT_EQ(p.colors[v], before.colors[s]);
  }
}

TEST(split_vertices, keeps_influence_groups_whole) {
  Primitive p = rich_primitive();
  split_vertices(p, std::vector<std::uint32_t>{5, 5, 5, 6, 6, 6});
  ASSERT_EQ(p.influences.groups.size(), 2u);
  const auto &two = p.influences.groups[0], &one = p.influences.groups[1];
  EXPECT_EQ(two.first_vertex, 0u);
  EXPECT_EQ(two.vertex_count, 5u);
  EXPECT_EQ(two.first_influence, 0u);
  EXPECT_EQ(one.first_vertex, 5u);
  EXPECT_EQ(one.vertex_count, 1u);
  EXPECT_EQ(one.first_influence, 10u);
  EXPECT_THAT(p.influences.joints, ElementsAre(10, 11, 10, 11, 20, 21, 30, 31, 30, 31, 40));
  EXPECT_THAT(p.influences.weights, ElementsAre(0.9f, 0.1f, 0.9f, 0.1f, 0.8f, 0.2f, 0.7f, 0.3f, 0.7f, 0.3f, 1.0f));
}

TEST(split_vertices, repeats_morph_deltas_for_each_copy) {
  Primitive p = rich_primitive();
  split_vertices(p, std::vector<std::uint32_t>{5, 5, 5, 6, 6, 6});
  const MorphTarget& target = p.morphs.targets[0];
  EXPECT_THAT(target.positions.vertices, ElementsAre(0, 1, 3, 4));
  EXPECT_EQ(target.positions.deltas[1], glm::vec3(1, 2, 3));
  EXPECT_EQ(target.positions.deltas[3], glm::vec3(4, 5, 6));
  EXPECT_THAT(target.normals.vertices, ElementsAre(3, 4));
  EXPECT_THAT(target.tangents.vertices, ElementsAre(0, 1));
  EXPECT_THAT(target.colors.vertices, ElementsAre(5));
  EXPECT_THAT(target.texcoords[0].vertices, ElementsAre(3, 4));
}

TEST(split_vertices, composes_with_the_source_vertices_of_an_earlier_split) {
  Primitive p = rich_primitive();
  p.source_vertex = {9, 8, 7, 6};
  split_vertices(p, std::vector<std::uint32_t>{5, 5, 5, 6, 6, 6});
  EXPECT_THAT(p.source_vertex, ElementsAre(9, 9, 8, 7, 7, 6));
}

TEST(split_vertices, changes_nothing_when_groups_agree) {
  Primitive p = rich_primitive();
  split_vertices(p, std::vector<std::uint32_t>{3, 4, 5, 3, 5, 6});
  EXPECT_THAT(p.indices, ElementsAre(0, 1, 2, 0, 2, 3));
  EXPECT_TRUE(p.source_vertex.empty());
}

TEST(split_vertices, gives_a_corner_without_group_an_existing_copy) {
  Primitive p = rich_primitive();
  split_vertices(p, std::vector<std::uint32_t>{kNone, 1, kNone, 2, kNone, 3});
  EXPECT_EQ(p.vertex_count(), 4u);
}

TEST(split_vertices, keeps_a_vertex_that_no_face_uses) {
  Primitive p = test::triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}}, {0, 1, 2, 2, 1, 0});
  split_vertices(p, std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5});
  EXPECT_EQ(p.vertex_count(), 7u);
  EXPECT_EQ(p.positions[6], glm::vec3(5));
  EXPECT_EQ(p.source_vertex[6], 3u);
}

}  // namespace
}  // namespace sinew
