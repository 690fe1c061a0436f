// SPDX-License-Identifier: MIT
#include "importer/topology/normals.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/importer/tiny_surfaces.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using test::is_near;
using test::kEps;

TEST(make_flat_normals, G46_splits_every_corner_and_marks_the_primitive) {
  Primitive p = test::cube();
  p.tangents.assign(8, {1, 0, 0, 1});
  MorphTarget target;
  target.positions = {{3}, {{0, 0, 1}}};
  target.normals = {{0}, {{0, 1, 0}}};
  target.tangents = {{0}, {{0, 1, 0}}};
  p.morphs.targets = {target};
  make_flat_normals(p);

  EXPECT_TRUE(p.flat_normals);
  EXPECT_TRUE(p.tangents.empty());
  EXPECT_EQ(p.vertex_count(), 36u);
  EXPECT_EQ(p.source_vertex.size(), 36u);
  EXPECT_TRUE(p.morphs.targets[0].normals.empty());
  EXPECT_TRUE(p.morphs.targets[0].tangents.empty());
  EXPECT_EQ(p.morphs.targets[0].positions.vertices.size(), 5u);  // vertex 3 lies in five faces
  std::vector<int> used(36, 0);
  for (const std::uint32_t v : p.indices) ++used[v];
  EXPECT_THAT(used, testing::Each(1));
}

TEST(make_flat_normals, order_corners_so_that_they_lie_in_a_row) {
  Primitive p = test::cube();
  make_flat_normals(p);
  for (std::uint32_t f = 0; f < 12; ++f) {
    EXPECT_LT(p.indices[3 * f], 12u);
    for (std::uint32_t k = 1; k < 3; ++k) EXPECT_EQ(p.indices[3 * f + k], 12 * k + p.indices[3 * f]);
  }
}

TEST(make_flat_normals, point_out_of_the_faces_of_a_cube) {
  Primitive p = test::cube();
  make_flat_normals(p);
  for (std::size_t f = 0; f < 12; ++f) {
    glm::vec3 centre(0);
    for (std::size_t k = 0; k < 3; ++k) centre += p.positions[p.indices[3 * f + k]] / 3.0f;
    const glm::vec3 outwards = glm::vec3(glm::ivec3(centre));  // truncation keeps only the one coordinate that is +-1
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(p.normals[p.indices[3 * f + k]], outwards);
  }
}

TEST(make_flat_normals, agree_with_the_cross_product_in_long_double_from_1e_minus_30_to_1e30) {
  test::FixedRandom random(3);
  for (int round = 0; round < 2000; ++round) {
    const auto size = static_cast<float>(std::pow(10.0, random.in(-30, 30)));
    Primitive p = test::triangles({random.vec3() * size, random.vec3() * size, random.vec3() * size}, {0, 1, 2});
    make_flat_normals(p);
    using V = Vec3<long double>;
    const V a = V(p.positions[1]) - V(p.positions[0]), b = V(p.positions[2]) - V(p.positions[0]);
    const V n{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    const long double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    EXPECT_TRUE(is_near(Vec3<double>(p.normals[0]), Vec3<double>(n / length), 2 * kEps)) << "size " << size;
  }
}

TEST(make_flat_normals, of_faces_without_area_are_finite_and_of_unit_length) {
  for (auto positions : {std::vector<glm::vec3>(3, glm::vec3(2)),
                         {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}},
                         {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}}) {
    Primitive p = test::triangles(positions, {0, 1, 2});
    make_flat_normals(p);
    EXPECT_THAT(p.normals, testing::Each(glm::vec3(0, 0, 1)));
  }
}

TEST(make_flat_normals, leave_lines_and_points_alone) {
  for (const Topology topology : {Topology::points, Topology::lines}) {
    Primitive p = test::triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 1, 2, 3});
    p.topology = topology;
    make_flat_normals(p);
    EXPECT_TRUE(p.normals.empty());
    EXPECT_FALSE(p.flat_normals);
  }
}

}  // namespace
}  // namespace sinew
