// SPDX-License-Identifier: MIT
#include "tests/reference/rooms.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace sinew::reference {
namespace {

void add_quad(std::vector<RayTriangle>& out, const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v) {
  const glm::dvec3 n = glm::normalize(glm::cross(u, v));
  out.push_back({{corner, corner + u, corner + u + v}, {n, n, n}});
  out.push_back({{corner, corner + u + v, corner + v}, {n, n, n}});
}

}  // namespace

std::vector<RayTriangle> room(double height, bool behind, bool right) {
  constexpr double s = 6.0;
  std::vector<RayTriangle> out;
  add_quad(out, {-s, 0, s}, {2 * s, 0, 0}, {0, 0, -2 * s});
  add_quad(out, {-1, 0, s}, {0, 0, -2 * s}, {0, height, 0});
  if (behind) add_quad(out, {-s, 0, -1}, {2 * s, 0, 0}, {0, height, 0});
  if (right) add_quad(out, {1, 0, -s}, {0, 0, 2 * s}, {0, height, 0});
  return out;
}

glm::dvec3 scattered(const glm::dvec3& n, test::FixedRandom& random) {
  const glm::dvec3 x = glm::normalize(glm::cross(std::abs(n.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), n));
  const double sine = std::sqrt(random.unit()), turn = 2.0 * std::numbers::pi * random.unit();
  return sine * (std::cos(turn) * x + std::sin(turn) * glm::cross(n, x)) + std::sqrt(1.0 - sine * sine) * n;
}

void add_path(const std::vector<RayTriangle>& triangles, const glm::dvec3& from, const glm::dvec3& direction,
              double weight, test::FixedRandom& random, Paths& out) {
  glm::dvec3 p = from, d = direction;
  for (double& ended : out) {
    const auto hit = cast(triangles, p, d);
    if (!hit) {
      ended += weight;
      return;
    }
    p += d * hit->t + hit->normal * 1e-9;
    d = scattered(hit->normal, random);
  }
}

double light_of(const Paths& paths, double albedo) {
  double sum = 0.0, left = 1.0;
  for (const double ended : paths) {
    sum += left * ended;
    left *= albedo;
  }
  return sum;
}

}  // namespace sinew::reference
