// SPDX-License-Identifier: MIT
#include "importer/topology/flat_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/deform/flat_faces.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

using testing::ElementsAre;

glm::vec3 mark(std::size_t vertex) { return glm::vec3(static_cast<float>(vertex)); }

/// Separate triangles over vertices of one, two or three influences in random order, with every attribute. An
/// attribute's value identifies its vertex.
Primitive marked_triangles(FixedRandom& random, std::uint32_t triangle_count) {
  const std::uint32_t vertices = 3 * triangle_count + 2;  // two are in no triangle
  Primitive p;
  p.texcoords.resize(1);
  MorphTarget target;
  target.texcoords.resize(1);
  const auto add_group = [&](std::uint32_t first, std::uint32_t end, std::uint32_t count) {
    p.influences.groups.push_back({first, end - first, count, static_cast<std::uint32_t>(p.influences.joints.size())});
    for (std::uint32_t v = first; v < end; ++v)
      for (std::uint32_t i = 0; i < count; ++i) {
        p.influences.joints.push_back(static_cast<std::uint16_t>(v));
        p.influences.weights.push_back(static_cast<float>(i));
      }
  };
  add_group(0, vertices / 3, 1);
  add_group(vertices / 3, vertices / 3 * 2, 2);
  add_group(vertices / 3 * 2, vertices, 3);
  for (std::uint32_t v = 0; v < vertices; ++v) {
    p.positions.push_back(mark(v));
    p.normals.push_back(mark(v));
    p.tangents.push_back(glm::vec4(mark(v), 1));
    p.texcoords[0].push_back(glm::vec2(mark(v)));
    p.colors.push_back(glm::vec4(mark(v), 1));
    if (v % 2 == 0) continue;
    target.positions.vertices.push_back(v);
    target.positions.deltas.push_back(mark(v));
    target.texcoords[0].vertices.push_back(v);
    target.texcoords[0].deltas.push_back(glm::vec2(mark(v)));
  }
  p.morphs.targets = {target};
  for (std::uint32_t i = 0; i < 3 * triangle_count; ++i) p.indices.push_back(i);
  for (std::uint32_t i = 3 * triangle_count; i > 1; --i) std::swap(p.indices[i - 1], p.indices[random.below(i)]);
  return p;
}

/// In every array, the new vertices are copies of the old ones that `source_vertex` names.
void expect_whole_vertices(const Primitive& p) {
  for (std::size_t v = 0; v < p.vertex_count(); ++v) {
    const glm::vec3 old = mark(p.source_vertex[v]);
    EXPECT_EQ(p.positions[v], old);
    EXPECT_EQ(p.normals[v], old);
    EXPECT_EQ(p.tangents[v], glm::vec4(old, 1));
    EXPECT_EQ(p.texcoords[0][v], glm::vec2(old));
    EXPECT_EQ(p.colors[v], glm::vec4(old, 1));
  }
  for (const InfluenceGroup& group : p.influences.groups)
    for (std::uint32_t v = 0; v < group.vertex_count; ++v)
      for (std::uint32_t i = 0; i < group.influence_count; ++i) {
        const std::size_t at = group.first_influence + v * group.influence_count + i;
        EXPECT_EQ(p.influences.joints[at], p.source_vertex[group.first_vertex + v]);
        EXPECT_EQ(p.influences.weights[at], static_cast<float>(i));
      }
  const MorphTarget& target = p.morphs.targets[0];
  EXPECT_TRUE(std::is_sorted(target.positions.vertices.begin(), target.positions.vertices.end()));
  EXPECT_EQ(target.positions.vertices.size(), p.vertex_count() / 2);
  for (std::size_t i = 0; i < target.positions.vertices.size(); ++i)
    EXPECT_EQ(target.positions.deltas[i], mark(p.source_vertex[target.positions.vertices[i]]));
  EXPECT_EQ(target.texcoords[0].vertices, target.positions.vertices);
  EXPECT_EQ(target.texcoords[0].deltas[0], glm::vec2(target.positions.deltas[0]));
}

TEST(order_flat_corners, puts_nearly_all_triangles_into_streams) {
  FixedRandom random(46);
  Primitive p = marked_triangles(random, 2000);
  EXPECT_TRUE(sort_flat_faces(p.indices, p.vertex_count()).streams.empty());
  order_flat_corners(p);
  const FlatFaces faces = sort_flat_faces(p.indices, p.vertex_count());
  EXPECT_EQ(faces.streams.size(), 27u) << "one for each three groups";
  EXPECT_TRUE(faces.corners.empty());
  EXPECT_TRUE(faces.alone.empty());
}

TEST(order_flat_corners, moves_whole_vertices_within_their_groups_and_keeps_triangles) {
  FixedRandom random(47);
  Primitive p = marked_triangles(random, 300);
  const Primitive before = p;
  order_flat_corners(p);
  ASSERT_EQ(p.influences.groups.size(), 3u);
  for (std::size_t g = 0; g < 3; ++g) {
    EXPECT_EQ(p.influences.groups[g].first_vertex, before.influences.groups[g].first_vertex);
    EXPECT_EQ(p.influences.groups[g].vertex_count, before.influences.groups[g].vertex_count);
  }
  expect_whole_vertices(p);
  for (std::size_t i = 0; i < p.indices.size(); ++i) EXPECT_EQ(p.positions[p.indices[i]], mark(before.indices[i]));
}

TEST(order_flat_corners, orders_meshes_without_influences_by_corner) {
  Primitive p;
  p.positions.resize(7);
  p.indices = {0, 1, 2, 3, 4, 5};
  order_flat_corners(p);
  EXPECT_THAT(p.indices, ElementsAre(0, 2, 4, 1, 3, 5));
  EXPECT_THAT(p.source_vertex, ElementsAre(0, 3, 1, 4, 2, 5, 6));
}

TEST(order_flat_corners, leaves_what_is_in_order) {
  Primitive p;
  p.positions.resize(6);
  p.indices = {0, 2, 4, 1, 3, 5};
  order_flat_corners(p);
  EXPECT_TRUE(p.source_vertex.empty());
}

}  // namespace
}  // namespace sinew::test
