// SPDX-License-Identifier: MIT
#include "importer/topology/tangents.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "importer/topology/normals.h"
#include "tests/importer/tiny_surfaces.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using test::is_near;
using test::kEps;
using testing::Each;

/// Every tangent is finite, of unit length, perpendicular to its normal, and has a handedness.
::testing::AssertionResult well_formed(const Primitive& p) {
  if (p.tangents.size() != p.vertex_count()) return ::testing::AssertionFailure() << p.tangents.size() << " tangents";
  for (std::size_t v = 0; v < p.vertex_count(); ++v) {
    const glm::dvec3 t(p.tangents[v]), n(p.normals[v]);
    if (!(std::abs(glm::dot(t, t) - 1) < 8 * kEps && std::abs(glm::dot(t, n)) < 4 * kEps) ||
        (p.tangents[v].w != 1.0f && p.tangents[v].w != -1.0f))
      return ::testing::AssertionFailure() << "vertex " << v << ": " << t.x << " " << t.y << " " << t.z;
  }
  return ::testing::AssertionSuccess();
}

TEST(make_tangents, of_an_upright_texture_point_right_with_the_bitangent_up) {
  Primitive p = test::upright_square();
  make_tangents(p, 0);
  EXPECT_EQ(p.vertex_count(), 4u);
  EXPECT_THAT(p.tangents, Each(glm::vec4(1, 0, 0, 1)));
}

TEST(make_tangents, of_a_mirrored_texture_have_the_other_handedness) {
  Primitive p = test::upright_square();
  for (glm::vec2& uv : p.texcoords[0]) uv.x = -uv.x;
  make_tangents(p, 0);
  EXPECT_THAT(p.tangents, Each(glm::vec4(-1, 0, 0, -1)));
}

TEST(make_tangents, of_a_turned_texture_turn_with_it) {
  Primitive p = test::upright_square();
  for (glm::vec2& uv : p.texcoords[0]) uv = {uv.y, -uv.x};  // u falls with y, v falls with x
  make_tangents(p, 0);
  EXPECT_THAT(p.tangents, Each(glm::vec4(0, -1, 0, 1)));
}

TEST(make_tangents, split_vertices_on_a_mirror_seam) {
  // Two squares side by side; the texture is mirrored about the shared edge x = 0.
  Primitive p = test::triangles({{-1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {1, 0, 0}, {1, 1, 0}},
                                {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2});
  p.normals.assign(6, {0, 0, 1});
  p.texcoords = {{{1, 1}, {0, 1}, {0, 0}, {1, 0}, {1, 1}, {1, 0}}};
  make_tangents(p, 0);
  EXPECT_EQ(p.vertex_count(), 8u);
  for (std::size_t c = 0; c < 12; ++c) {
    const glm::vec4 expected = c < 6 ? glm::vec4(-1, 0, 0, -1) : glm::vec4(1, 0, 0, 1);
    EXPECT_EQ(p.tangents[p.indices[c]], expected) << "corner " << c;
  }
}

TEST(make_tangents, are_shared_by_vertices_that_agree_in_position_normal_and_texcoord) {
  Primitive indexed = test::upright_square();
  indexed.positions[2].z = 0.5f;  // bent along the diagonal, so that the two faces differ
  indexed.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  Primitive loose = indexed;
  loose.positions.clear();
  loose.normals.clear();
  loose.texcoords[0].clear();
  loose.indices.clear();
  for (const std::uint32_t v : indexed.indices) {
    loose.indices.push_back(static_cast<std::uint32_t>(loose.positions.size()));
    loose.positions.push_back(indexed.positions[v]);
    loose.normals.push_back(indexed.normals[v]);
    loose.texcoords[0].push_back(indexed.texcoords[0][v]);
  }
  make_tangents(indexed, 0);
  make_tangents(loose, 0);
  EXPECT_EQ(loose.vertex_count(), 6u);
  for (std::size_t c = 0; c < 6; ++c) EXPECT_EQ(indexed.tangents[indexed.indices[c]], loose.tangents[loose.indices[c]]);
}

TEST(make_tangents, weigh_faces_by_their_angle_at_the_vertex) {
  // Two faces share the edge (0,0)-(0,1). In the first u rises along (1,0), in the second along (1,1).
  Primitive p = test::triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 1, 0}}, {0, 1, 2, 0, 2, 3});
  p.normals.assign(4, {0, 0, 1});
  p.texcoords = {{{0, 0}, {1, 0}, {0, -1}, {-1, -2}}};
  make_tangents(p, 0);
  ASSERT_EQ(p.vertex_count(), 4u);
  const glm::vec3 first(1, 0, 0), second = glm::vec3(1, 1, 0) * std::sqrt(0.5f);
  EXPECT_TRUE(is_near(glm::vec3(p.tangents[0]), glm::normalize(2.0f * first + second), 4 * kEps));  // 90 and 45 degrees
  EXPECT_TRUE(is_near(glm::vec3(p.tangents[2]), glm::normalize(first + 2.0f * second), 4 * kEps));  // 45 and 90 degrees
  EXPECT_TRUE(is_near(glm::vec3(p.tangents[1]), first, 2 * kEps));
  EXPECT_TRUE(is_near(glm::vec3(p.tangents[3]), second, 2 * kEps));
}

TEST(make_tangents, without_texture_area_are_still_perpendicular_units) {
  for (const glm::vec3& n : {glm::vec3(0, 0, 1), {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0.6f, 0.0f, -0.8f}}) {
    Primitive p = test::upright_square();
    p.normals.assign(4, n);
    p.texcoords[0].assign(4, {0.5f, 0.5f});
    make_tangents(p, 0);
    EXPECT_TRUE(well_formed(p));
    for (const glm::vec4& tangent : p.tangents) EXPECT_EQ(tangent.w, 1.0f) << "nothing is mirrored";
    // The expected tangent is the cross product of the normal with the axis farthest from it.
    const glm::vec3 axis = n.x == 0.0f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    EXPECT_TRUE(is_near(glm::vec3(p.tangents[0]), glm::cross(n, axis), kEps)) << n.x;
  }
}

TEST(make_tangents, of_a_face_without_texture_area_come_from_its_neighbour) {
  Primitive p = test::upright_square();
  p.texcoords[0][3] = {0.5f, 0.5f};  // vertex 3 lies on the diagonal in the texture: the second face has no area there
  make_tangents(p, 0);
  EXPECT_EQ(p.vertex_count(), 4u);
  EXPECT_EQ(p.tangents[0], glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(p.tangents[2], glm::vec4(1, 0, 0, 1));
  EXPECT_TRUE(well_formed(p));
}

TEST(make_tangents, drop_morph_deltas_of_tangents) {
  Primitive p = test::upright_square();
  p.morphs.targets.resize(1);
  p.morphs.targets[0].tangents = {{0}, {{1, 0, 0}}};
  make_tangents(p, 0);
  EXPECT_TRUE(p.morphs.targets[0].tangents.empty());
}

TEST(make_tangents, need_normals_texcoords_and_triangles) {
  Primitive no_set = test::upright_square();
  make_tangents(no_set, 1);
  EXPECT_TRUE(no_set.tangents.empty());
  Primitive no_normals = test::upright_square();
  no_normals.normals.clear();
  make_tangents(no_normals, 0);
  EXPECT_TRUE(no_normals.tangents.empty());
}

/// The tangents along u of a torus are known in closed form.
TEST(make_tangents, of_a_torus_follow_its_circles) {
  Primitive p;
  constexpr std::uint32_t kRound = 48, kTube = 24;
  p.texcoords.resize(1);
  std::vector<glm::vec3> circle;
  for (std::uint32_t i = 0; i <= kRound; ++i)
    for (std::uint32_t j = 0; j <= kTube; ++j) {
      const double a = 2 * M_PI * (i % kRound) / kRound, b = 2 * M_PI * (j % kTube) / kTube;
      const glm::dvec3 out(std::cos(a), 0, -std::sin(a));
      const glm::dvec3 n = out * std::cos(b) + glm::dvec3(0, std::sin(b), 0);
      p.positions.push_back(glm::vec3(out * 3.0 + n));
      p.normals.push_back(glm::vec3(n));
      p.texcoords[0].push_back({float(i) / kRound, 1.0f - float(j) / kTube});
      circle.push_back(glm::vec3(-std::sin(a), 0, -std::cos(a)));
    }
  for (std::uint32_t i = 0; i < kRound; ++i)
    for (std::uint32_t j = 0; j < kTube; ++j) {
      const std::uint32_t a = i * (kTube + 1) + j, b = a + kTube + 1;
      p.indices.insert(p.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
    }
  make_tangents(p, 0);
  ASSERT_EQ(p.vertex_count(), circle.size());
  EXPECT_TRUE(well_formed(p));
  // At the seam the fan of faces is open on one side, so the tangent is half a step of 7.5 degrees off. Elsewhere the
  // error is far smaller.
  for (std::size_t v = 0; v < circle.size(); ++v) {
    EXPECT_GT(glm::dot(glm::vec3(p.tangents[v]), circle[v]), std::cos(0.07)) << v;
    EXPECT_EQ(p.tangents[v].w, 1.0f);
  }
}

TEST(make_tangents, of_random_soup_are_well_formed) {
  test::FixedRandom random(9);
  for (int round = 0; round < 300; ++round) {
    Primitive p;
    p.texcoords.resize(1);
    const std::uint32_t count = 3 + random.below(10);
    for (std::uint32_t v = 0; v < count; ++v) {
      p.positions.push_back(glm::vec3(glm::ivec3(random.vec3() * 2.5f)));
      p.normals.push_back(random.direction());
      p.texcoords[0].push_back(glm::vec2(glm::ivec2(random.vec3() * 2.5f)));
    }
    for (int i = 0; i < 45; ++i) p.indices.push_back(random.below(count));
    make_tangents(p, 0);
    ASSERT_TRUE(well_formed(p));
  }
}

}  // namespace
}  // namespace sinew
