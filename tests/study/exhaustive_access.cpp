// SPDX-License-Identifier: MIT
#include "tests/study/exhaustive_access.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace sinew::viewer {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kSlices = 16;      // two directions each
constexpr double kLevel = 0.02;  // least sine above the tangent plane, as in gtao.frag

struct Search {
  const SeenPixels& seen;
  glm::dmat3 world_from_view;
  glm::dvec3 eye;
  double radius_m, thickness_m, pixels_per_metre;  // at distance 1
};

/// Cosine of the angle between the line of sight and the highest body on one side.
double horizon(const Search& s, int x, int y, const glm::dvec2& step, int reach, const glm::dvec3& v, double lowest) {
  const auto width = static_cast<int>(s.seen.width), height = static_cast<int>(s.seen.height);
  const RayCaster::Seen& at = *s.seen.pixels[static_cast<std::size_t>(y * width + x)];
  double highest = lowest;
  for (int k = 1; k <= reach; ++k) {
    const int there_x = x + static_cast<int>(std::lround(k * step.x)),
              there_y = y + static_cast<int>(std::lround(k * step.y));
    if (there_x < 0 || there_y < 0 || there_x >= width || there_y >= height) break;
    const auto& there = s.seen.pixels[static_cast<std::size_t>(there_y * width + there_x)];
    if (!there) continue;
    const glm::dvec3 to_r = there->point - at.point;
    const double away = glm::length(to_r), along = glm::dot(to_r, v);
    const double to_body = glm::length(to_r - std::clamp(along, 0.0, s.thickness_m) * v);
    if (away == 0.0 || to_body >= s.radius_m || glm::dot(to_r, at.normal) <= kLevel * away) continue;
    highest = std::max(highest, along / away);
  }
  return highest;
}

/// Light of a slice from the line of sight to the angle h on one side, where the normal is at the angle g.
/// eq   integral of cos(t - g) sin t over t from 0 to h
double light_up_to(double h, double g) { return 0.25 * (std::cos(g) + 2.0 * h * std::sin(g) - std::cos(2.0 * h - g)); }

double access_at(const Search& s, int x, int y) {
  const RayCaster::Seen& at = *s.seen.pixels[static_cast<std::size_t>(y) * s.seen.width + static_cast<std::size_t>(x)];
  const glm::dvec3 to_eye = s.eye - at.point, v = glm::normalize(to_eye), n = at.normal;
  const double distance = glm::dot(to_eye, s.world_from_view[2]);
  const int reach = static_cast<int>(std::ceil(s.radius_m * s.pixels_per_metre / distance));
  double hidden = 0.0;
  for (int i = 0; i < kSlices; ++i) {
    const double turn = (i + 0.5) * kPi / kSlices;
    const glm::dvec2 step(std::cos(turn), std::sin(turn));  // pixels, y down
    const glm::dvec3 direction = s.world_from_view * glm::dvec3(step.x, -step.y, 0.0);
    const glm::dvec3 aside = glm::normalize(direction - v * glm::dot(direction, v)), axis = glm::cross(aside, v),
                     m = n - axis * glm::dot(n, axis);
    const double g = std::atan2(glm::dot(m, aside), glm::dot(m, v));
    const auto hidden_on = [&](const glm::dvec2& way, double normal) {
      const double free = 0.5 * kPi + normal;
      const double met = std::acos(std::clamp(horizon(s, x, y, way, reach, v, std::cos(free)), -1.0, 1.0));
      return light_up_to(free, normal) - light_up_to(met, normal);
    };
    hidden += glm::length(m) / kSlices * (hidden_on(step, g) + hidden_on(-step, -g));
  }
  return std::clamp(1.0 - hidden, 0.0, 1.0);
}

}  // namespace

std::vector<double> exhaustive_access(const SeenPixels& seen, const View& view, double radius_m, double thickness) {
  const Affined& rows = view.view_from_world;
  const glm::dmat3 world_from_view(glm::dvec3(rows.row[0]), glm::dvec3(rows.row[1]), glm::dvec3(rows.row[2]));
  const Search search{seen,     world_from_view,      eye_of(view),
                      radius_m, thickness * radius_m, 0.5 * seen.height / std::tan(0.5 * view.fov_y_rad)};
  std::vector<double> access;
  for (std::uint32_t y = 0; y < seen.height; ++y)
    for (std::uint32_t x = 0; x < seen.width; ++x)
      access.push_back(seen.pixels[std::size_t{y} * seen.width + x]
                           ? access_at(search, static_cast<int>(x), static_cast<int>(y))
                           : 1.0);
  return access;
}

}  // namespace sinew::viewer
