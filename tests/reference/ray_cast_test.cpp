// SPDX-License-Identifier: MIT
#include "tests/reference/ray_cast.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/fixed_random.h"

namespace sinew::reference {
namespace {

constexpr double kFloatRoundoff = 0x1p-24;

RayTriangle triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 n = glm::cross(b - a, c - a);
  return {{a, b, c}, {n, n, n}, 0};
}

glm::dvec3 rounded_to_float(const glm::dvec3& p) { return glm::dvec3(glm::vec3(p)); }

/// A tilted square of 8 x 8 cells of `cell` metres each around `center`, with corners rounded to float. Its exact
/// normal is nearly `normal`.
std::vector<RayTriangle> tilted_floor(const glm::dvec3& center, const glm::dvec3& normal, double cell) {
  const glm::dvec3 u = glm::normalize(glm::cross(normal, {0.3, 0.1, 0.9})), v = glm::cross(normal, u);
  const auto corner = [&](int i, int j) { return rounded_to_float(center + (i - 4) * cell * u + (j - 4) * cell * v); };
  std::vector<RayTriangle> floor;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) {
      floor.push_back(triangle(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)));
      floor.push_back(triangle(corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)));
    }
  return floor;
}

/// Counts the points of `t`, of `count` random ones rounded to float, from which some upward ray hits t itself. The
/// back of t is tested too, because a ray may start below it.
int self_hits(const RayTriangle& t, bool leave, int count, test::FixedRandom& random) {
  const std::vector<RayTriangle> own{t, triangle(t.corners[0], t.corners[2], t.corners[1])};
  const glm::dvec3 n = glm::normalize(glm::cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]));
  int hits = 0;
  for (int i = 0; i < count; ++i) {
    double a = random.unit(), b = random.unit();
    if (a + b > 1) {
      a = 1 - a;
      b = 1 - b;
    }
    const glm::dvec3 p =
        rounded_to_float(t.corners[0] + a * (t.corners[1] - t.corners[0]) + b * (t.corners[2] - t.corners[0]));
    const glm::dvec3 start = leave ? leave_surface(p, n, kFloatRoundoff) : p;
    hits += open_share(own, start, n, 1.0, 16) < 1.0;
  }
  return hits;
}

TEST(ray_cast, N36_rays_do_not_meet_the_triangle_that_they_leave) {
  test::FixedRandom random(36);
  int without_offset = 0;
  for (const double distance : {0.0, 1.0, 100.0, 1e4, 1e6})
    for (int turn = 0; turn < 8; ++turn) {
      const glm::dvec3 normal = random.direction<double>();
      const glm::dvec3 center = distance * random.direction<double>();
      for (const double cell : {1.0 + distance * 1e-5, 100.0 + distance * 1e-3}) {
        const RayTriangle own = tilted_floor(center, normal, cell)[37];
        EXPECT_EQ(self_hits(own, true, 50, random), 0) << distance << " m from the origin, cells of " << cell;
        without_offset += self_hits(own, false, 50, random);
      }
    }
  EXPECT_GT(without_offset, 100) << "points on the surface itself hit nothing: the cases prove nothing";
}

TEST(ray_cast, N36_the_offset_is_micrometres_near_the_origin_and_grows_with_distance) {
  const glm::dvec3 up(0, 1, 0);
  const auto offset = [&](const glm::dvec3& p) { return leave_surface(p, up, kFloatRoundoff).y - p.y; };
  EXPECT_LT(offset({1, 1, 1}), 1e-6);
  EXPECT_LT(offset({10, 0, 0}), 1e-5);
  EXPECT_GT(offset({1000, 0, 0}), 1000 * kFloatRoundoff);
  EXPECT_EQ(offset({0, 0, 0}), 0.0);
}

TEST(ray_cast, N36_no_ray_slips_through_edges_and_corners_of_a_closed_surface) {
  test::FixedRandom random(7);
  for (int turn = 0; turn < 40; ++turn) {
    // A box seen from inside, cut into triangles, turned and moved, corners rounded to float.
    const Quat<double> q = random.rotation<double>();
    const glm::dvec3 center = std::pow(10.0, random.in(-2, 5)) * random.direction<double>();
    glm::dvec3 corners[8];
    for (int i = 0; i < 8; ++i)
      corners[i] =
          rounded_to_float(center + rotate_vector(q, glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 2 : -2, i & 4 ? 3 : -3)));
    constexpr int kFaces[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
    std::vector<RayTriangle> box;
    for (const auto& f : kFaces) {
      box.push_back(triangle(corners[f[0]], corners[f[1]], corners[f[2]]));
      box.push_back(triangle(corners[f[0]], corners[f[2]], corners[f[3]]));
    }
    const auto expect_hit = [&](const glm::dvec3& target) {
      EXPECT_TRUE(cast(box, center, target - center)) << "box " << turn;
    };
    for (const glm::dvec3& corner : corners) expect_hit(corner);
    for (const RayTriangle& t : box)
      for (int e = 0; e < 3; ++e)
        for (int k = 1; k < 64; ++k) expect_hit(glm::mix(t.corners[e], t.corners[(e + 1) % 3], k / 64.0));
    EXPECT_EQ(open_share(box, center, random.direction<double>(), 1e300, 256), 0.0);
  }
}

TEST(ray_cast, N36_triangles_without_area_block_nothing_and_give_no_NaN) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const glm::dvec3 a(-1, 1, -1), b(1, 1, 1.0 / 3);
  std::vector<RayTriangle> flat{triangle(a, b, a), triangle(a, a, a), triangle(a, b, a + (b - a) * 0.7),
                                triangle(a, b, 0.5 * (a + b))};
  for (RayTriangle& t : flat)
    for (glm::dvec3& n : t.normals) n = glm::dvec3(kNan);  // normalising a zero normal gives NaN
  for (int k = 0; k <= 100; ++k) EXPECT_FALSE(cast(flat, glm::dvec3(0), glm::mix(a, b, k / 100.0))) << k;
  flat.push_back(triangle({-5, 2, -5}, {5, 2, -5}, {0, 2, 5}));
  const auto hit = cast(flat, glm::dvec3(0), glm::mix(a, b, 0.5));
  ASSERT_TRUE(hit) << "what lies behind them is seen";
  EXPECT_TRUE(std::isfinite(hit->normal.y));
}

TEST(ray_cast, N36_directions_are_a_fixed_cosine_weighted_sequence) {
  // A wall fills the half x > 0 of the hemisphere, so the share is known in closed form.
  const glm::dvec3 up(0, 0, 1);
  const std::vector<RayTriangle> wall{triangle({0.001, -1e6, -1e6}, {0.001, 0, 1e9}, {0.001, 1e6, -1e6})};
  const double share = open_share(wall, glm::dvec3(0), up, 1e300, 4096);
  EXPECT_NEAR(share, 0.5, 0.01);
  EXPECT_EQ(share, open_share(wall, glm::dvec3(0), up, 1e300, 4096)) << "another call, the same rays";
  // A ceiling at height 1 of radius r blocks r^2 / (1 + r^2) of the cosine-weighted hemisphere.
  std::vector<RayTriangle> disc;
  const double r = 1.5;
  for (int i = 0; i < 64; ++i) {
    const auto rim = [&](int k) { return glm::dvec3(r * std::cos(k * M_PI / 32), r * std::sin(k * M_PI / 32), 1); };
    disc.push_back(triangle({0, 0, 1}, rim(i + 1), rim(i)));
  }
  EXPECT_NEAR(1 - open_share(disc, glm::dvec3(0), up, 1e300, 4096), r * r / (1 + r * r), 0.005);
  EXPECT_EQ(open_share(disc, glm::dvec3(0), up, 0.99, 4096), 1.0) << "beyond the radius nothing counts";
}

}  // namespace
}  // namespace sinew::reference
