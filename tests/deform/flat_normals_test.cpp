// SPDX-License-Identifier: MIT
#include "runtime/deform/flat_normals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "tests/support/fixed_random.h"
#include "tests/support/near.h"
#include "tests/support/simd_targets.h"

namespace sinew::test {
namespace {

using Indices = std::vector<std::uint32_t>;
using Points = std::vector<glm::vec3>;

/// The normals of rest are (0, 1, 0); what the job leaves alone stays (9, 9, 9).
Points flat(const Points& positions, const Indices& triangles, bool turned = false) {
  const Points rest(positions.size(), glm::vec3(0, 1, 0));
  Points normals(positions.size() + 1, glm::vec3(9));
  const FlatFaces faces = sort_flat_faces(triangles, positions.size());
  run(FlatNormalsJob{.faces = &faces,
                     .positions = positions,
                     .rest_normals = rest,
                     .turned = turned,
                     .normals = std::span(normals).first(positions.size())});
  EXPECT_EQ(normals.back(), glm::vec3(9)) << "written past the end";
  normals.pop_back();
  return normals;
}

Points flat(const Points& positions, bool turned = false) { return flat(positions, {0, 1, 2}, turned); }

TEST(flat_normals, G46_a_face_has_the_normal_of_its_winding) {
  for (const glm::vec3& n : flat({{0, 0, 0}, {2, 0, 0}, {0, 3, 0}})) EXPECT_EQ(n, glm::vec3(0, 0, 1));
  for (const glm::vec3& n : flat({{0, 0, 0}, {0, 3, 0}, {2, 0, 0}})) EXPECT_EQ(n, glm::vec3(0, 0, -1));
  for (const glm::vec3& n : flat({{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}, true)) EXPECT_EQ(n, glm::vec3(0, 0, -1));
}

TEST(flat_normals, tiny_and_huge_faces_have_unit_normals) {
  for (const float size : {1e-30f, 1e-12f, 1.0f, 1e12f, 1e30f})
    for (const glm::vec3& n : flat({{0, 0, 0}, {size, 0, 0}, {0, size, size}}))
      EXPECT_TRUE(is_near(n, glm::vec3(0, -0.70710678f, 0.70710678f), 1e-7)) << size;
}

TEST(flat_normals, a_face_without_area_keeps_the_normals_of_rest) {
  for (const glm::vec3& n : flat({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}})) EXPECT_EQ(n, glm::vec3(0, 1, 0));
}

TEST(flat_normals, vertices_of_no_face_keep_the_normals_of_rest) {
  EXPECT_EQ(flat({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}})[3], glm::vec3(0, 1, 0));
}

TEST(flat_normals, where_faces_share_vertices_the_last_one_decides) {
  const Points corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 0}};
  const Points normals = flat(corners, {0, 1, 2, 0, 2, 3, 0, 1, 4});
  EXPECT_EQ(normals[0], glm::vec3(1, 0, 0)) << "the last face has no area";
  EXPECT_EQ(normals[1], glm::vec3(0, 0, 1));
  EXPECT_EQ(normals[2], glm::vec3(1, 0, 0));
  EXPECT_EQ(normals[4], glm::vec3(0, 1, 0));
}

/// A face of any shape from equilateral to nearly a line, and of any size.
void add_face(FixedRandom& random, Points& to) {
  const bool ordinary = random.below(10) > 0;
  const double size = std::pow(10.0, ordinary ? random.in(-3, 1) : random.in(-18, 18));
  const double width = std::pow(10.0, random.in(-4, 0));
  const Vec3<double> at = size * random.vec3<double>(), along = size * random.vec3<double>();
  const Vec3<double> across = size * width * random.vec3<double>();
  to.insert(to.end(), {glm::vec3(at), glm::vec3(at + along), glm::vec3(at + along * random.in(-1, 1) + across)});
}

Indices vertex_order(FixedRandom& random, std::size_t count, bool in_a_row) {
  Indices order(count);
  std::iota(order.begin(), order.end(), 0u);
  if (!in_a_row)
    for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
  return order;
}

Vec3<double> exact_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  using Exact = Vec3<long double>;
  const Exact n = glm::cross(Exact(b) - Exact(a), Exact(c) - Exact(a));
  return Vec3<double>(n / std::sqrt(glm::dot(n, n)));
}

double largest_error(const Points& positions, const Points& normals, const Indices& triangles) {
  double largest = 0.0;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const Vec3<double> exact =
        exact_normal(positions[triangles[i]], positions[triangles[i + 1]], positions[triangles[i + 2]]);
    for (std::size_t c = 0; c < 3; ++c) {
      const double error = glm::length(Vec3<double>(normals[triangles[i + c]]) - exact);
      largest = error <= largest ? largest : error;
    }
  }
  return largest;
}

TEST(flat_normals, faces_of_any_shape_and_size_have_their_exact_normals_to_2e_6) {
  FixedRandom random(46);
  for (const std::int64_t target : simd_targets()) {
    const OnlyTarget only(target);
    for (std::size_t count : {1, 2, 3, 4, 5, 8, 9, 15, 16, 17, 33, 300, 3000})
      for (const bool in_a_row : {true, false}) {
        Points faces;
        for (std::size_t f = 0; f < count; ++f) add_face(random, faces);
        const Indices triangles = vertex_order(random, faces.size(), in_a_row);
        Points positions(faces.size());
        for (std::size_t i = 0; i < faces.size(); ++i) positions[triangles[i]] = faces[i];
        const Points normals = flat(positions, triangles);
        EXPECT_LT(largest_error(positions, normals, triangles), 2e-6)
            << simd_name(target) << " " << count << (in_a_row ? " in a row" : "");
      }
  }
}

TEST(flat_normals, an_edge_whose_square_underflows_is_not_taken_for_a_wide_angle) {
  const Points face = {{0, 0, 0}, glm::vec3(1, 1, 1.000001f) * 1e-24f, glm::vec3(1e16f)};
  for (const std::int64_t target : simd_targets()) {
    const OnlyTarget only(target);
    EXPECT_LT(largest_error(face, flat(face), {0, 1, 2}), 2e-6) << simd_name(target);
  }
}

TEST(flat_normals, careful_faces_do_not_depend_on_how_many_there_are) {
  for (const std::int64_t target : simd_targets()) {
    const OnlyTarget only(target);
    for (const std::size_t count : {63, 64, 65, 127, 128, 129, 5000}) {
      Points positions;
      for (std::size_t f = 0; f < count; ++f) positions.insert(positions.end(), {{0, 0, 0}, {1, 0, 0}, {1, 1e-6f, 0}});
      Indices triangles(positions.size());
      std::iota(triangles.begin(), triangles.end(), 0u);
      const Points normals = flat(positions, triangles, true);
      EXPECT_TRUE(
          std::all_of(normals.begin(), normals.end(), [](const glm::vec3& n) { return n == glm::vec3(0, 0, -1); }))
          << simd_name(target) << " " << count;
    }
  }
}

}  // namespace
}  // namespace sinew::test
