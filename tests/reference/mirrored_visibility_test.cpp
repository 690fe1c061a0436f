// SPDX-License-Identifier: MIT
// Reflections of floors beside walls: cones around the bent normal, compared with traced rays and light paths.
#include "tests/reference/mirrored_visibility.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/reference/lobe_rays.h"
#include "tests/reference/rooms.h"

namespace sinew::reference {
namespace {

constexpr glm::dvec3 kUp(0, 1, 0);

struct FloorPoint {
  std::vector<RayTriangle> triangles;
  glm::dvec3 p{0.0};
  Openness open;
};

Openness openness_at(const std::vector<RayTriangle>& triangles, const glm::dvec3& p, test::FixedRandom& random) {
  constexpr int count = 1500;
  int open = 0;
  glm::dvec3 sum(0.0);
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 d = scattered(kUp, random);
    if (cast(triangles, p, d)) continue;
    ++open;
    sum += d;
  }
  return {.visibility = static_cast<double>(open) / count, .bend = glm::normalize(sum) - kUp};
}

std::vector<FloorPoint> floor_points(test::FixedRandom& random) {
  std::vector<FloorPoint> points;
  for (const std::vector<RayTriangle>& triangles :
       {room(2.0, false, false), room(1.0, true, false), room(1.5, false, true), room(0.7, true, true)})
    for (int i = 0; i < 15; ++i) {
      const glm::dvec3 p(random.in(-0.99, 0.99), 1e-9, random.in(-0.99, 1.5));
      points.push_back({triangles, p, openness_at(triangles, p, random)});
    }
  return points;
}

/// A random direction from the point that no triangle blocks.
glm::dvec3 viewer_of(const FloorPoint& point, test::FixedRandom& random) {
  for (;;) {
    const double y = random.in(0.1, 1.0), turn = random.in(0.0, 2.0 * std::numbers::pi), out = std::sqrt(1.0 - y * y);
    const glm::dvec3 v(out * std::cos(turn), y, out * std::sin(turn));
    if (!cast(point.triangles, point.p, v)) return v;
  }
}

/// eq   Lagarde and de Rousiers, "Moving Frostbite to Physically Based Rendering" (2014), listing 26
double lagarde(double visibility, double n_v, double roughness) {
  return std::clamp(std::pow(n_v + visibility, std::exp2(-16.0 * roughness - 1.0)) - 1.0 + visibility, 0.0, 1.0);
}

struct Errors {
  double cone = 0.0, visibility = 0.0, lagarde = 0.0;
};

/// Root mean square errors of the light that floors of this roughness reflect, one per albedo of the surfaces.
std::vector<Errors> errors_of(double roughness, const std::vector<double>& albedos) {
  test::FixedRandom random(3);
  std::vector<Errors> sums(albedos.size());
  double count = 0.0;
  for (const FloorPoint& point : floor_points(random))
    for (int i = 0; i < 4; ++i, ++count) {
      const glm::dvec3 v = viewer_of(point, random);
      Paths paths{};
      for (const LobeRay& ray : lobe_rays(kUp, v, roughness, 150, random.unit()))
        add_path(point.triangles, point.p, ray.direction, ray.weight, random, paths);
      const double mirrored = mirrored_visibility(point.open, kUp, v, roughness), visibility = point.open.visibility;
      for (std::size_t a = 0; a < albedos.size(); ++a) {
        const double truth = light_of(paths, albedos[a]);
        const double light = mirrored + mirrored_surroundings(point.open, mirrored, glm::dvec3(albedos[a])).x;
        sums[a].cone += std::pow(light - truth, 2.0);
        sums[a].visibility += std::pow(visibility - truth, 2.0);
        sums[a].lagarde += std::pow(lagarde(visibility, v.y, roughness) - truth, 2.0);
      }
    }
  for (Errors& e : sums) e = {std::sqrt(e.cone / count), std::sqrt(e.visibility / count), std::sqrt(e.lagarde / count)};
  return sums;
}

TEST(mirrored_visibility, is_nearer_to_rays_and_to_paths_of_light_than_visibility_alone_and_than_lagarde) {
  struct Bounds {
    double roughness, in_black;  // error limit where surfaces scatter nothing
  };
  for (const Bounds& bounds : {Bounds{0.1, 0.34}, {0.3, 0.26}, {0.5, 0.17}, {0.7, 0.09}}) {
    const std::vector<double> albedos = {0.0, 0.2, 0.5, 0.8};
    const std::vector<Errors> errors = errors_of(bounds.roughness, albedos);
    EXPECT_LT(errors[0].cone, bounds.in_black) << bounds.roughness;
    for (std::size_t i = 0; i < errors.size(); ++i) {
      EXPECT_LT(errors[i].cone, 0.85 * errors[i].visibility) << bounds.roughness << " albedo " << albedos[i];
      EXPECT_LT(errors[i].cone, 0.85 * errors[i].lagarde) << bounds.roughness << " albedo " << albedos[i];
    }
  }
}

TEST(mirrored_visibility, is_one_in_the_open_and_equals_visibility_without_a_bent_normal) {
  const glm::dvec3 v = glm::normalize(glm::dvec3(0.9, 0.2, 0.0));
  for (const double roughness : {0.05, 0.4, 1.0}) {
    EXPECT_NEAR(mirrored_visibility({.bend = glm::dvec3(0.0)}, kUp, v, roughness), 1.0, 1e-12);
    EXPECT_EQ(mirrored_visibility({.visibility = 0.3, .baked = 0.5}, kUp, v, roughness), 0.15);
    EXPECT_NEAR(mirrored_visibility({.visibility = 0.3, .bend = glm::dvec3(0.0), .baked = 0.5}, kUp, v, 1.0), 0.15,
                1e-12);
  }
  EXPECT_EQ(mirrored_surroundings({.visibility = 0.3}, 0.3, {1, 1, 1}), glm::dvec3(0.0));
}

TEST(mirrored_visibility, is_less_on_the_side_of_the_wall) {
  const Openness open{.visibility = 0.6, .bend = glm::normalize(glm::dvec3(0.5, 1.0, 0.0)) - kUp};  // wall at -x
  const glm::dvec3 from_wall = glm::normalize(glm::dvec3(-0.8, 0.6, 0.0)), towards = {-from_wall.x, from_wall.y, 0.0};
  for (const double roughness : {0.1, 0.5}) {
    EXPECT_GT(mirrored_visibility(open, kUp, from_wall, roughness), 0.7);
    EXPECT_LT(mirrored_visibility(open, kUp, towards, roughness), 0.4);
  }
}

/// Estimates the overlap by random points on the sphere: the share in both circles, times 2 because areas are parts of
/// the half sphere.
TEST(mirrored_visibility, circles_overlap_as_much_as_points_that_lie_in_both) {
  test::FixedRandom random(5);
  for (int i = 0; i < 40; ++i) {
    const double cos_a = random.in(0.0, 0.9), cos_b = random.in(0.0, 0.9), between = random.in(0.0, 2.0);
    const glm::dvec3 other(std::sin(between), std::cos(between), 0.0);
    int both = 0;
    constexpr int count = 20000;
    for (int k = 0; k < count; ++k) {
      const glm::dvec3 d = random.direction<double>();
      both += d.y > cos_a && glm::dot(d, other) > cos_b;
    }
    EXPECT_NEAR(overlap(cos_a, cos_b, std::cos(between)), 2.0 * both / count, 0.1) << cos_a << ' ' << cos_b;
  }
  EXPECT_NEAR(overlap(0.5, 0.8, 1.0), 0.2, 1e-12);
  EXPECT_EQ(overlap(0.9, 0.9, -1.0), 0.0);
}

}  // namespace
}  // namespace sinew::reference
