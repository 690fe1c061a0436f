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
  EXPECT_EQ(run(FlatNormalsJob{.faces = &faces,
                               .positions = positions,
                               .rest_normals = rest,
                               .turned = turned,
                               .normals = std::span(normals).first(positions.size())}),
            ErrorCode::ok);
  EXPECT_EQ(normals.back(), glm::vec3(9)) << "written past the end";
  normals.pop_back();
  return normals;
}

/// Normals of one face, which is repeated until it fills the widest vectors.
Points flat_face(const Points& face, bool turned = false) {
  constexpr std::uint32_t kCopies = FlatStream::kFewest;
  Points positions;
  Indices triangles;
  for (const glm::vec3& corner : face) positions.insert(positions.end(), kCopies, corner);
  for (std::uint32_t t = 0; t < kCopies; ++t) triangles.insert(triangles.end(), {t, kCopies + t, 2 * kCopies + t});
  const Points normals = flat(positions, triangles, turned);
  for (std::size_t v = 0; v < positions.size(); ++v) EXPECT_EQ(normals[v], normals[v / kCopies * kCopies]) << v;
  return {normals[0], normals[kCopies], normals[2 * kCopies]};
}

TEST(flat_normals, G46_a_face_has_the_normal_of_its_winding) {
  for (const glm::vec3& n : flat_face({{0, 0, 0}, {2, 0, 0}, {0, 3, 0}})) EXPECT_EQ(n, glm::vec3(0, 0, 1));
  for (const glm::vec3& n : flat_face({{0, 0, 0}, {0, 3, 0}, {2, 0, 0}})) EXPECT_EQ(n, glm::vec3(0, 0, -1));
  for (const glm::vec3& n : flat_face({{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}, true)) EXPECT_EQ(n, glm::vec3(0, 0, -1));
}

TEST(flat_normals, tiny_and_huge_faces_have_unit_normals) {
  for (const float size : {1e-30f, 1e-12f, 1.0f, 1e12f, 1e30f})
    for (const glm::vec3& n : flat_face({{0, 0, 0}, {size, 0, 0}, {0, size, size}}))
      EXPECT_TRUE(is_near(n, glm::vec3(0, -0.70710678f, 0.70710678f), 1e-7)) << size;
}

TEST(flat_normals, a_face_without_area_keeps_the_normals_of_rest) {
  for (const glm::vec3& n : flat_face({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}})) EXPECT_EQ(n, glm::vec3(0, 1, 0));
}

TEST(flat_normals, vertices_of_no_face_keep_the_normals_of_rest) {
  EXPECT_EQ(flat({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}}, {0, 1, 2})[3], glm::vec3(0, 1, 0));
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

/// How the vertices of triangles lie in memory: by corner, triangle after triangle, or anyhow.
enum class VertexOrder { streams, in_a_row, shuffled };

Indices indices_of(VertexOrder order, std::size_t face_count, FixedRandom& random) {
  Indices indices(3 * face_count);
  for (std::size_t i = 0; i < indices.size(); ++i)
    indices[i] = static_cast<std::uint32_t>(order == VertexOrder::streams ? i % 3 * face_count + i / 3 : i);
  if (order == VertexOrder::shuffled)
    for (std::size_t i = indices.size(); i > 1; --i)
      std::swap(indices[i - 1], indices[random.below(static_cast<std::uint32_t>(i))]);
  return indices;
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
      for (const VertexOrder order : {VertexOrder::streams, VertexOrder::in_a_row, VertexOrder::shuffled}) {
        Points faces;
        for (std::size_t f = 0; f < count; ++f) add_face(random, faces);
        const Indices triangles = indices_of(order, count, random);
        Points positions(faces.size());
        for (std::size_t i = 0; i < faces.size(); ++i) positions[triangles[i]] = faces[i];
        const Points normals = flat(positions, triangles);
        EXPECT_LT(largest_error(positions, normals, triangles), 2e-6)
            << simd_name(target) << " " << count << " order " << static_cast<int>(order);
      }
  }
}

TEST(flat_normals, an_edge_whose_square_underflows_is_not_taken_for_a_wide_angle) {
  const Points face = {{0, 0, 0}, glm::vec3(1, 1, 1.000001f) * 1e-24f, glm::vec3(1e16f)};
  for (const std::int64_t target : simd_targets()) {
    const OnlyTarget only(target);
    EXPECT_LT(largest_error(face, flat_face(face), {0, 1, 2}), 2e-6) << simd_name(target);
  }
}

/// Two right-angled edges whose product of squares is finite in float, while the square of their product is not.
Points face_whose_area_overflows() {
  FixedRandom random(128);
  for (int i = 0; i < 1'000'000; ++i) {
    const auto a = static_cast<float>(0x1p32 * random.in(1, 2));
    const auto b = static_cast<float>(0x1p64 / double{a});
    if (std::isinf((a * b) * (a * b)) && !std::isinf((a * a) * (b * b))) return {{0, 0, 0}, {a, 0, 0}, {0, b, 0}};
  }
  return {};
}

TEST(flat_normals, an_area_that_overflows_is_not_taken_for_a_wide_angle) {
  const Points face = face_whose_area_overflows();
  ASSERT_EQ(face.size(), 3u);
  for (const std::int64_t target : simd_targets()) {
    const OnlyTarget only(target);
    for (const glm::vec3& n : flat_face(face)) EXPECT_EQ(n, glm::vec3(0, 0, 1)) << simd_name(target);
  }
}

TEST(flat_normals, careful_faces_do_not_depend_on_how_many_there_are_nor_on_their_order) {
  FixedRandom random(64);
  const glm::vec3 face[3] = {{0, 0, 0}, {1, 0, 0}, {1, 1e-6f, 0}};
  for (const std::int64_t target : simd_targets()) {
    const OnlyTarget only(target);
    for (const std::size_t count : {16, 17, 63, 64, 65, 127, 128, 129, 5000})
      for (const VertexOrder order : {VertexOrder::streams, VertexOrder::in_a_row}) {
        const Indices triangles = indices_of(order, count, random);
        Points positions(3 * count);
        for (std::size_t i = 0; i < triangles.size(); ++i) positions[triangles[i]] = face[i % 3];
        const Points normals = flat(positions, triangles, true);
        EXPECT_TRUE(
            std::all_of(normals.begin(), normals.end(), [](const glm::vec3& n) { return n == glm::vec3(0, 0, -1); }))
            << simd_name(target) << " " << count;
      }
  }
}

}  // namespace
}  // namespace sinew::test
