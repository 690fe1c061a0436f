// SPDX-License-Identifier: MIT
#include "runtime/deform/surface_normals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "runtime/base/same_bits.h"
#include "runtime/math/affine.h"
#include "runtime/math/quaternion.h"
#include "tests/reference/surface.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"
#include "tests/support/simd_targets.h"

namespace sinew::test {
namespace {

using Points = std::vector<glm::vec3>;

std::vector<glm::vec3> normals_of(const Primitive& rest, const Points& moved, bool turned = false) {
  const SurfaceFaces faces = join_surface(rest, false);
  std::vector<glm::vec4> sums(surface_sums(faces));
  std::vector<glm::vec3> normals(moved.size() + 1, glm::vec3(9));
  EXPECT_EQ(run(SurfaceNormalsJob{.faces = &faces,
                                  .positions = moved,
                                  .rest_normals = rest.normals,
                                  .turned = turned,
                                  .sums = sums,
                                  .normals = std::span(normals).first(moved.size())}),
            ErrorCode::ok);
  EXPECT_EQ(normals.back(), glm::vec3(9)) << "written past the end";
  normals.pop_back();
  return normals;
}

std::vector<glm::vec4> tangents_of(const Primitive& rest, const Points& moved) {
  const SurfaceFaces faces = join_surface(rest, true);
  std::vector<glm::vec4> tangents(moved.size());
  EXPECT_EQ(run(SurfaceTangentsJob{
                .faces = &faces, .positions = moved, .rest_tangents = rest.tangents, .tangents = tangents}),
            ErrorCode::ok);
  return tangents;
}

/// A flat grid of squares with two triangles each, cut along either diagonal; a seam doubles the vertices of one
/// column.
/// in   growth  of the squares, from column to column and row to row
Primitive grid(int columns, int rows, float growth = 0.0f) {
  Primitive out;
  const auto place = [&](int i) { return static_cast<float>(i) * (1.0f + growth * static_cast<float>(i)); };
  const auto add = [&](int x, int y) {
    out.positions.emplace_back(place(x), place(y), 0);
    out.normals.emplace_back(0, 0, 1);
    out.tangents.emplace_back(1, 0, 0, x % 2 == 0 ? 1.0f : -1.0f);
    return static_cast<std::uint32_t>(out.positions.size() - 1);
  };
  std::vector<std::uint32_t> left, right;
  for (int x = 0; x < columns; ++x) {
    left = right;
    right.clear();
    for (int y = 0; y < rows; ++y) right.push_back(add(x, y));
    for (std::size_t y = 0; x > 0 && y + 1 < right.size(); ++y) {
      const std::uint32_t a = left[y], b = right[y], c = left[y + 1], e = right[y + 1];
      if (y % 2 == 0)
        out.indices.insert(out.indices.end(), {a, b, c, c, b, e});
      else
        out.indices.insert(out.indices.end(), {a, b, e, a, e, c});
    }
    if (x != columns / 2) continue;
    right.clear();
    for (int y = 0; y < rows; ++y) right.push_back(add(x, y));  // the seam
  }
  return out;
}

Points waved(const Primitive& rest, FixedRandom& random, float size = 1.0f) {
  Points out;
  for (const glm::vec3& p : rest.positions)
    out.push_back(size * glm::vec3(p.x + 0.2f * p.y, p.y, std::sin(0.8f * p.x) + 0.3f * std::cos(1.7f * p.y)));
  for (glm::vec3& p : out) p.z += 0.1f * size * static_cast<float>(random.unit());
  for (std::size_t v = 0; v < out.size(); ++v)  // the same on both sides of a seam
    for (std::size_t w = v + 1; w < out.size(); ++w)
      if (rest.positions[v] == rest.positions[w]) out[w] = out[v];
  return out;
}

/// The largest rounding that the header allows for the normal of a vertex, in radians.
double allowed(const Primitive& rest, const Points& moved, std::size_t vertex) {
  const std::vector<reference::Point> exact(moved.begin(), moved.end());
  const std::vector<std::size_t> joined = reference::joined_with(rest, vertex);
  double lengths = 0.0;
  for (std::size_t i = 0; i < rest.indices.size(); ++i)
    if (std::find(joined.begin(), joined.end(), rest.indices[i]) != joined.end()) {
      const std::uint32_t* const t = &rest.indices[i / 3 * 3];
      lengths += glm::length(exact[t[1]] - exact[t[0]]) * glm::length(exact[t[2]] - exact[t[0]]);
    }
  return 8.0 * 0x1p-24 * lengths / (2.0 * glm::length(reference::vector_area(rest, exact, joined)));
}

TEST(surface_normals, are_within_rounding_of_the_vector_area_of_the_ring_on_every_instruction_set) {
  const Primitive rest = grid(9, 7, 0.1f);
  FixedRandom random(3);
  for (const std::int64_t target : simd_targets()) {
    const OnlyTarget only(target);
    for (const float size : {1e-9f, 1e-3f, 1.0f, 1e9f}) {
      const Points moved = waved(rest, random, size);
      const std::vector<reference::Point> exact(moved.begin(), moved.end());
      const std::vector<reference::Point> truth = reference::surface_normals(rest, exact, true);
      const std::vector<glm::vec3> normals = normals_of(rest, moved, true);
      for (std::size_t v = 0; v < normals.size(); ++v)
        ASSERT_LE(glm::distance(glm::dvec3(normals[v]), truth[v]), allowed(rest, moved, v) + 1e-7)
            << simd_name(target) << " size " << size << " vertex " << v;
    }
  }
}

TEST(surface_normals, have_one_set_of_bits_where_multiply_add_is_fused_and_one_where_it_is_not) {
  const Primitive rest = grid(9, 7);
  FixedRandom random(4);
  const Points moved = waved(rest, random);
  std::vector<glm::vec3> first[2];
  for (const std::int64_t target : simd_targets()) {
    const OnlyTarget only(target);
    std::vector<glm::vec3>& expected = first[fuses_multiply_add(target)];
    const std::vector<glm::vec3> normals = normals_of(rest, moved);
    if (expected.empty()) expected = normals;
    EXPECT_TRUE(same_bits<glm::vec3>(normals, expected)) << simd_name(target);
  }
}

TEST(surface_normals, are_smooth_over_seams_and_sharp_at_sharp_edges) {
  const Primitive rest = grid(4, 3);
  Points folded = rest.positions;
  for (glm::vec3& p : folded)
    if (p.x > 2.0f) p.z = 1.0f;
  const std::vector<glm::vec3> normals = normals_of(rest, folded);
  for (std::size_t v = 0; v < folded.size(); ++v)
    for (std::size_t w = 0; w < folded.size(); ++w)
      if (rest.positions[v] == rest.positions[w]) {
        EXPECT_EQ(normals[v], normals[w]);
      }
  Primitive sharp = rest;
  for (std::size_t v = 0; v < 9; ++v) sharp.normals[v] = {0, 1, 0};  // on one side of the seam, at x = 2
  const std::vector<glm::vec3> apart = normals_of(sharp, folded);
  EXPECT_EQ(apart[7], glm::vec3(0, 0, 1));
  EXPECT_TRUE(is_near(apart[10], glm::vec3(-0.70710678f, 0, 0.70710678f), 1e-6));
}

TEST(surface_normals, do_not_depend_on_how_the_ring_is_cut) {
  Primitive fan;  // a square ring around the first vertex, and the same with more triangles on one side
  fan.positions = {{0, 0, 0}, {1, 0, 0.5f}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0.5f, 0.5f, 0.25f}};
  fan.normals.assign(6, {0, 0, 1});
  fan.indices = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};
  const glm::vec3 whole = normals_of(fan, fan.positions)[0];
  fan.indices = {0, 1, 5, 0, 5, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};
  EXPECT_TRUE(is_near(normals_of(fan, fan.positions)[0], whole, 1e-7));
}

TEST(surface_normals, points_without_area_or_triangles_keep_the_normals_of_rest) {
  Primitive rest = grid(2, 2);
  rest.positions.push_back({9, 9, 9});
  rest.normals.assign(rest.positions.size(), glm::vec3(0, 1, 0));
  const Points collapsed(rest.positions.size(), glm::vec3(3.0f));
  for (const glm::vec3& n : normals_of(rest, collapsed)) EXPECT_EQ(n, glm::vec3(0, 1, 0));
}

TEST(surface_tangents, follow_an_affine_map_as_skinning_does) {
  FixedRandom random(9);
  for (int k = 0; k < 20; ++k) {
    Primitive rest = grid(4, 4);
    for (glm::vec4& t : rest.tangents) {
      const double angle = random.in(-3.0, 3.0);
      t = glm::vec4(std::cos(angle), std::sin(angle), 0.0, t.w);
    }
    Affine m;
    for (glm::vec4& row : m.row) row = glm::vec4(random.vec3(-1.0, 1.0), 2.0f);
    Points moved;
    for (const glm::vec3& p : rest.positions) moved.push_back(transform_point(m, p));
    const std::vector<glm::vec4> tangents = tangents_of(rest, moved);
    for (std::size_t v = 0; v < tangents.size(); ++v) {
      const glm::vec3 t(rest.tangents[v]), expected = normalised_or(transform_vector(m, t), t);
      EXPECT_TRUE(is_near(glm::vec3(tangents[v]), expected, 2e-4)) << k << " vertex " << v;
      EXPECT_EQ(tangents[v].w, rest.tangents[v].w);
    }
  }
}

TEST(surface_tangents, agree_with_the_plain_sum_over_triangles) {
  const Primitive rest = grid(6, 5, 0.3f);
  FixedRandom random(5);
  const Points moved = waved(rest, random);
  const std::vector<reference::Point> exact(moved.begin(), moved.end());
  const std::vector<reference::Point> truth = reference::surface_tangents(rest, exact);
  const std::vector<glm::vec4> tangents = tangents_of(rest, moved);
  for (std::size_t v = 0; v < tangents.size(); ++v)
    EXPECT_LE(glm::distance(glm::dvec3(tangents[v]), truth[v]), 2e-6) << v;
}

}  // namespace
}  // namespace sinew::test
