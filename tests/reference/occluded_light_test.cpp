// SPDX-License-Identifier: MIT
// Light that surroundings scatter, beside paths of light, on floors in white light with walls around them.
#include "tests/reference/occluded_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/reference/ray_cast.h"
#include "tests/support/fixed_random.h"

namespace sinew::reference {
namespace {

using Triangles = std::vector<RayTriangle>;

void add_quad(Triangles& out, const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v) {
  const glm::dvec3 n = glm::normalize(glm::cross(u, v));
  out.push_back({{corner, corner + u, corner + u + v}, {n, n, n}});
  out.push_back({{corner, corner + u + v, corner + v}, {n, n, n}});
}

/// A floor in the plane y = 0 with walls 1 m from its middle.
Triangles room(double height, bool behind, bool right) {
  constexpr double s = 6.0;
  Triangles out;
  add_quad(out, {-s, 0, s}, {2 * s, 0, 0}, {0, 0, -2 * s});
  add_quad(out, {-1, 0, s}, {0, 0, -2 * s}, {0, height, 0});
  if (behind) add_quad(out, {-s, 0, -1}, {2 * s, 0, 0}, {0, height, 0});
  if (right) add_quad(out, {1, 0, -s}, {0, 0, 2 * s}, {0, height, 0});
  return out;
}

/// A direction over the half sphere, as often as its cosine to the normal is large.
glm::dvec3 scattered(const glm::dvec3& n, test::FixedRandom& random) {
  const glm::dvec3 x = glm::normalize(glm::cross(std::abs(n.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), n));
  const double sine = std::sqrt(random.unit()), turn = 2.0 * std::numbers::pi * random.unit();
  return sine * (std::cos(turn) * x + std::sin(turn) * glm::cross(n, x)) + std::sqrt(1.0 - sine * sine) * n;
}

using Paths = std::array<double, 16>;

/// Shares of the paths from a point on the floor that end in the sky after 0, 1, 2 ... surfaces.
Paths paths_to_sky(const Triangles& triangles, const glm::dvec3& from, test::FixedRandom& random) {
  constexpr int count = 1500;
  Paths out{};
  for (int i = 0; i < count; ++i) {
    glm::dvec3 p = from, n(0, 1, 0);
    for (double& ended : out) {
      const glm::dvec3 d = scattered(n, random);
      const auto hit = cast(triangles, p, d);
      if (!hit) {
        ended += 1.0 / count;
        break;
      }
      n = hit->normal;
      p += d * hit->t + n * 1e-9;
    }
  }
  return out;
}

double light_of(const Paths& paths, double albedo) {
  double sum = 0.0, left = 1.0;
  for (const double ended : paths) {
    sum += left * ended;
    left *= albedo;
  }
  return sum;
}

TEST(scattered_access, is_nearer_to_paths_of_light_than_access_alone) {
  test::FixedRandom random(3);
  std::vector<Paths> points;
  for (const Triangles& triangles :
       {room(2.0, false, false), room(1.0, true, false), room(1.5, false, true), room(0.7, true, true)})
    for (int i = 0; i < 15; ++i)
      points.push_back(paths_to_sky(triangles, {random.in(-0.99, 0.99), 1e-9, random.in(-0.99, 1.5)}, random));
  for (const double albedo : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    double with = 0.0, without = 0.0;
    for (const Paths& paths : points) {
      const double truth = light_of(paths, albedo);
      with += std::pow(scattered_access(paths[0], glm::dvec3(albedo)).x - truth, 2.0);
      without += std::pow(paths[0] - truth, 2.0);
    }
    EXPECT_LT(with, 0.4 * without) << albedo;
    EXPECT_LT(std::sqrt(with / static_cast<double>(points.size())), 0.06) << albedo;
  }
}

TEST(scattered_access, keeps_dark_and_light_and_takes_colour_from_the_surface) {
  EXPECT_EQ(scattered_access(1.0, {1.0, 0.5, 0.0}), glm::dvec3(1.0));
  EXPECT_EQ(scattered_access(0.0, {1.0, 0.5, 0.0}), glm::dvec3(0.0));
  const glm::dvec3 half = scattered_access(0.5, {0.9, 0.5, 0.0});
  EXPECT_EQ(half.b, 0.5);
  EXPECT_GT(half.r, half.g + 0.05);
  EXPECT_GT(half.g, half.b + 0.05);
}

}  // namespace
}  // namespace sinew::reference
