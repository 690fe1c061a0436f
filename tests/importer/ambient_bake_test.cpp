// SPDX-License-Identifier: MIT
// Ambient visibility, compared with closed forms and a double-precision reference, and the rules of averaging.
#include "importer/ambient/bake_ambient_visibility.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include <tbb/global_control.h>

#include "tests/reference/ambient_visibility.h"
#include "tests/support/fixed_random.h"

namespace sinew {
namespace {

using test::FixedRandom;

/// A square with corners a, a + u, a + u + v, a + v, as a fan of triangles around the point at (s, t), its last vertex.
VisibilitySurface fan(const glm::vec3& a, const glm::vec3& u, const glm::vec3& v, float s, float t) {
  VisibilitySurface surface;
  surface.positions = {a, a + u, a + u + v, a + v, a + s * u + t * v};
  surface.indices = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
  surface.normals.assign(5, glm::normalize(glm::cross(u, v)));
  return surface;
}

/// A square floor that faces +y, with a vertex in its middle; `half` = half its side.
VisibilitySurface floor_at(float height, float half) {
  return fan({-half, height, half}, {2 * half, 0, 0}, {0, 0, -2 * half}, 0.5f, 0.5f);
}

/// The same square facing down.
VisibilitySurface ceiling_at(float height, float half) {
  return fan({-half, height, half}, {0, 0, -2 * half}, {2 * half, 0, 0}, 0.5f, 0.5f);
}

/// The six sides of a box of half size 1, facing inwards, each with a vertex in its middle.
std::vector<VisibilitySurface> box_from_inside() {
  std::vector<VisibilitySurface> sides;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0f, 1.0f}) {
      glm::vec3 u(0.0f), v(0.0f), a(-1.0f);
      a[axis] = side;
      u[(axis + 1) % 3] = v[(axis + 2) % 3] = 2.0f;  // u x v is along +axis
      sides.push_back(side < 0.0f ? fan(a, u, v, 0.5f, 0.5f) : fan(a, v, u, 0.5f, 0.5f));
    }
  return sides;
}

float middle_of(const std::vector<float>& visibility) { return visibility[4]; }

TEST(bake_ambient_visibility, N34_a_plane_sees_all_light) {
  const std::vector<VisibilitySurface> one = {floor_at(3.0f, 10.0f)};
  const auto visibility = bake_ambient_visibility(one);
  for (const float share : visibility[0]) EXPECT_EQ(share, 1.0f);
}

TEST(bake_ambient_visibility, N34_where_two_planes_meet_half_of_the_light_arrives_and_where_three_meet_a_quarter) {
  // A wall of height h and half width w at distance d hides atan(w / d) / pi - d / sqrt(d^2 + h^2) * atan(w / sqrt(d^2
  // + h^2)) / pi of a floor's cosine-weighted hemisphere: 1/2 for d = 0. The rays start 1/64 inside the faces, at most
  // h / 64 from the wall. That changes the share by at most 1/64 * (1 + 1/4).
  constexpr double kNear = 1.25 / 64 + 0.002;  // the last term is the error of the rays
  const std::vector<VisibilitySurface> two = {fan({0, 0, 2}, {2, 0, 0}, {0, 0, -4}, 0.0f, 0.5f),
                                              fan({0, 0, 2}, {0, 0, -4}, {0, 2, 0}, 0.5f, 0.0f)};
  for (const auto& plane : bake_ambient_visibility(two, {.rays = 4096})) EXPECT_NEAR(middle_of(plane), 0.5, kNear);
  const std::vector<VisibilitySurface> three = {fan({0, 0, 0}, {0, 0, 2}, {2, 0, 0}, 0.5f, 0.5f),
                                                fan({0, 0, 0}, {0, 2, 0}, {0, 0, 2}, 0.5f, 0.5f),
                                                fan({0, 0, 0}, {2, 0, 0}, {0, 2, 0}, 0.5f, 0.5f)};
  for (const auto& plane : bake_ambient_visibility(three, {.rays = 4096})) EXPECT_NEAR(plane[0], 0.25, kNear);
}

TEST(bake_ambient_visibility, N34_a_closed_box_is_black_inside_and_white_where_the_walls_are_out_of_reach) {
  const std::vector<VisibilitySurface> box = box_from_inside();
  for (const auto& side : bake_ambient_visibility(box))
    for (const float visibility : side) EXPECT_EQ(visibility, 0.0f);
  for (const auto& side : bake_ambient_visibility(box, {.distance_m = 0.95})) EXPECT_EQ(middle_of(side), 1.0f);
}

TEST(bake_ambient_visibility, N34_under_a_ceiling_the_distance_leaves_the_rays_outside_of_a_cone) {
  // cos^2 is uniform, and rays shorter than r with cos > h / r are blocked.
  for (const float height : {0.5f, 1.0f, 1.5f}) {
    const std::vector<VisibilitySurface> two = {floor_at(0.0f, 50.0f), ceiling_at(height, 50.0f)};
    const auto visibility = bake_ambient_visibility(two, {.rays = 1024, .distance_m = 2.0});
    EXPECT_NEAR(middle_of(visibility[0]), height * height / 4.0f, 0.004) << height;
    EXPECT_NEAR(middle_of(visibility[1]), height * height / 4.0f, 0.004) << height;
  }
}

TEST(bake_ambient_visibility, faces_count_by_their_angle_however_they_are_cut) {
  // A quarter of the floor (90 degrees) in the open, and an eighth (45 degrees) under a lid.
  for (const bool cut : {false, true}) {
    VisibilitySurface floor;
    floor.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, -1}, {-0.70710678f, 0, -0.70710678f}, {0.5f, 0, -0.5f}};
    floor.indices = {0, 2, 3};
    const std::vector<std::uint32_t> open =
        cut ? std::vector<std::uint32_t>{0, 1, 4, 0, 4, 2} : std::vector<std::uint32_t>{0, 1, 2};
    floor.indices.insert(floor.indices.end(), open.begin(), open.end());
    VisibilitySurface lid;
    lid.positions = {{0, 1e-4f, 3}, {0, 1e-4f, -3}, {-3, 1e-4f, -3}, {-3, 1e-4f, 3}};
    lid.indices = {0, 2, 1, 0, 3, 2};
    lid.both_sides = true;
    const std::vector<VisibilitySurface> both = {floor, lid};
    EXPECT_NEAR(bake_ambient_visibility(both, {.rays = 2048})[0][0], 2.0 / 3.0, 0.02) << cut;
  }
}

TEST(bake_ambient_visibility, vertices_that_differ_in_texture_alone_are_one_and_those_at_an_edge_are_not) {
  VisibilitySurface wall = fan({0, 0, 2}, {0, 0, -4}, {0, 2, 0}, 0.5f, 0.0f);
  VisibilitySurface near = fan({0, 0, 2}, {2, 0, 0}, {0, 0, -2}, 0.0f, 1.0f);
  VisibilitySurface far = fan({0, 0, 0}, {2, 0, 0}, {0, 0, -2}, 0.0f, 0.0f);
  VisibilitySurface hut = fan({0, 1e-3f, 0}, {0, 0, -2}, {2, 0, 0}, 0.5f, 0.5f);  // over one side of the seam
  hut.both_sides = true;
  const std::vector<VisibilitySurface> all = {wall, near, far, hut};
  const auto visibility = bake_ambient_visibility(all);
  EXPECT_EQ(middle_of(visibility[1]), middle_of(visibility[2]));
  EXPECT_NE(middle_of(visibility[0]), middle_of(visibility[1])) << "another normal";
  std::vector<VisibilitySurface> apart = all;
  apart[1].normals.clear();
  apart[2].normals.clear();
  const auto alone = bake_ambient_visibility(apart);
  EXPECT_GT(middle_of(alone[1]), middle_of(alone[2]) + 0.1f) << "each stands alone";
}

TEST(bake_ambient_visibility, only_fronts_block_unless_a_surface_has_two_sides_and_blended_ones_never_do) {
  VisibilitySurface roof = floor_at(1.0f, 50.0f);  // seen from below, this is its back
  std::vector<VisibilitySurface> both = {floor_at(0.0f, 1.0f), roof};
  EXPECT_EQ(middle_of(bake_ambient_visibility(both)[0]), 1.0f);
  both[1].both_sides = true;
  EXPECT_LT(middle_of(bake_ambient_visibility(both)[0]), 0.01f);
  both[1].blocks = false;
  EXPECT_EQ(middle_of(bake_ambient_visibility(both)[0]), 1.0f);
  EXPECT_EQ(middle_of(bake_ambient_visibility(both)[1]), 1.0f) << "it receives light all the same";
}

TEST(bake_ambient_visibility, vertices_of_no_face_and_triangles_without_area_are_open) {
  VisibilitySurface odd = floor_at(0.0f, 1.0f);
  odd.positions.emplace_back(0.0f, 0.0f, 0.0f);
  odd.positions.emplace_back(0.5f, 0.0f, 0.0f);
  odd.normals.resize(7, glm::vec3(1, 0, 0));
  odd.indices.insert(odd.indices.end(), {5, 6, 6, 5, 5, 5});
  const std::vector<VisibilitySurface> all = {odd, ceiling_at(0.5f, 9.0f)};
  const auto visibility = bake_ambient_visibility(all);
  EXPECT_EQ(visibility[0][5], 1.0f);
  EXPECT_EQ(visibility[0][6], 1.0f);
  EXPECT_LT(visibility[0][4], 0.1f);
  EXPECT_TRUE(bake_ambient_visibility({}).empty());
  EXPECT_TRUE(bake_ambient_visibility(std::vector<VisibilitySurface>(1)).front().empty());
}

/// Random triangles over a floor: some are two-sided, some have no normals.
std::vector<VisibilitySurface> random_surfaces(std::uint64_t seed) {
  FixedRandom random(seed);
  std::vector<VisibilitySurface> surfaces = {floor_at(-1.0f, 3.0f)};
  for (int s = 0; s < 4; ++s) {
    VisibilitySurface surface;
    for (int v = 0; v < 12; ++v) surface.positions.push_back(random.vec3());
    for (int i = 0; i < 24; ++i) surface.indices.push_back(random.below(12));
    if (s % 2 == 0)
      for (int v = 0; v < 12; ++v) surface.normals.push_back(glm::normalize(random.vec3()));
    surface.both_sides = s == 1;
    surface.blocks = s != 3;
    surfaces.push_back(std::move(surface));
  }
  return surfaces;
}

TEST(bake_ambient_visibility, N34_agrees_with_plain_double_precision_ray_by_ray) {
  // Both use the same rays. Only rays that pass an edge within float rounding may give another answer.
  std::size_t vertices = 0, differ = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed)
    for (const double distance : {0.7, std::numeric_limits<double>::infinity()}) {
      const std::vector<VisibilitySurface> surfaces = random_surfaces(seed);
      const VisibilityOptions options{.rays = 200, .distance_m = distance, .seed = seed};
      const auto fast = bake_ambient_visibility(surfaces, options);
      const auto truth = reference::ambient_visibility(surfaces, options);
      for (std::size_t s = 0; s < surfaces.size(); ++s)
        for (std::size_t v = 0; v < fast[s].size(); ++v) {
          const double off = std::abs(static_cast<double>(fast[s][v]) - truth[s][v]);
          EXPECT_LT(off, 0.02) << "seed " << seed << " surface " << s << " vertex " << v;
          ++vertices;
          differ += off > 1e-6;
        }
    }
  EXPECT_LT(differ, vertices / 100) << "of " << vertices;
}

TEST(bake_ambient_visibility, the_same_bits_for_any_number_of_threads_and_other_rays_for_another_seed) {
  const std::vector<VisibilitySurface> surfaces = random_surfaces(5);
  const auto many = bake_ambient_visibility(surfaces, {.rays = 64});
  {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(bake_ambient_visibility(surfaces, {.rays = 64}), many);
  }
  const auto others = bake_ambient_visibility(surfaces, {.rays = 64, .seed = 2});
  EXPECT_NE(others, many);
  double squares = 0.0, count = 0.0;
  for (std::size_t s = 0; s < many.size(); ++s)
    for (std::size_t v = 0; v < many[s].size(); ++v, ++count)
      squares += std::pow(static_cast<double>(others[s][v]) - static_cast<double>(many[s][v]), 2.0);
  EXPECT_LT(std::sqrt(squares / count), 0.05);
}

TEST(bake_ambient_visibility, tells_how_far_it_is) {
  std::vector<double> told;
  VisibilityOptions options{.rays = 1};
  options.progress = [&](double part) { told.push_back(part); };
  std::vector<VisibilitySurface> many(1800, floor_at(0.0f, 1.0f));
  for (VisibilitySurface& surface : many) surface.normals.clear();
  bake_ambient_visibility(many, options);
  ASSERT_EQ(told.size(), 3u);
  EXPECT_TRUE(0.0 < told[0] && told[0] < told[1] && told[1] < told[2] && told[2] == 1.0);
}

}  // namespace
}  // namespace sinew
