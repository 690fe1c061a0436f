// SPDX-License-Identifier: MIT
#include "tests/reference/gtao.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace sinew::reference {
namespace {

constexpr double kPi = std::numbers::pi;

/// A plane through the line of sight. Its angles are 0 towards the viewer and grow towards `aside`.
struct Slice {
  glm::dvec3 to_viewer, aside;

  double angle_of(const glm::dvec3& d) const { return std::atan2(glm::dot(d, aside), glm::dot(d, to_viewer)); }
};

/// Angle between the line of sight and the highest horizon on one side of a slice.
/// in   free  the angle of a free horizon: the tangent plane's
double horizon_angle(const DepthAndNormals& image, const HorizonSettings& s, int x, int y, const glm::dvec2& way,
                     double jitter, const glm::dvec3& to_viewer, double free) {
  const glm::dvec3 p = image.point(x, y), n = image.normals[static_cast<std::size_t>(y * image.width + x)];
  double least = kPi;
  for (int k = 0; k < s.steps; ++k) {
    const double part = (k + jitter) / s.steps;
    const glm::dvec2 at = way * std::pow(part, 1.5) + glm::normalize(way);
    const int there_x = x + static_cast<int>(std::lround(at.x)), there_y = y + static_cast<int>(std::lround(at.y));
    if (there_x < 0 || there_y < 0 || there_x >= image.width || there_y >= image.height) continue;
    const auto i = static_cast<std::size_t>(there_y * image.width + there_x);
    const glm::dvec3 to_r = image.point(there_x, there_y) - p;
    const double away = glm::length(to_r);
    if (image.distance[i] == 0.0 || away == 0.0 || away >= 1.3 * s.radius || glm::dot(to_r, n) <= 0.02 * away) continue;
    const double counts = std::clamp((1.3 - away / s.radius) / 0.35, 0.0, 1.0);
    const double cosine = counts * glm::dot(to_r, to_viewer) / away + (1.0 - counts) * std::cos(free);
    least = std::min(least, std::acos(std::clamp(cosine, -1.0, 1.0)));
  }
  return least;
}

/// An amount of light, and the sum of its directions weighted by amount.
struct Light {
  double amount = 0.0;
  glm::dvec3 directed{0.0};
};

/// Adds the light of a slice between two angles, weighted by the cosine to the normal, by the midpoint rule.
void add_light(const Slice& slice, double from, double to, double normal_angle, double weight, Light& light) {
  constexpr int kParts = 2000;
  for (int i = 0; i < kParts; ++i) {
    const double h = from + (to - from) * (i + 0.5) / kParts;
    const double part =
        weight * std::max(std::cos(h - normal_angle), 0.0) * std::abs(std::sin(h)) * (to - from) / kParts;
    light.amount += part;
    light.directed += part * (std::cos(h) * slice.to_viewer + std::sin(h) * slice.aside);
  }
}

/// Light that the horizons around a pixel hide.
Light hidden_at(const DepthAndNormals& image, const HorizonSettings& s, int x, int y, double turn, double jitter) {
  const glm::dvec3 p = image.point(x, y), n = image.normals[static_cast<std::size_t>(y * image.width + x)];
  const double radius_pixels = s.radius * 0.5 * image.cot_y * image.height / -p.z;
  const glm::dvec3 v = glm::normalize(-p);
  Light hidden;
  for (int i = 0; i < s.slices; ++i) {
    const double angle = (i + turn) * kPi / s.slices;
    const glm::dvec2 along(std::cos(angle), std::sin(angle));  // pixels, y down
    const glm::dvec3 direction(along.x, -along.y, 0.0);
    const Slice slice{v, glm::normalize(direction - v * glm::dot(direction, v))};
    const glm::dvec3 axis = glm::cross(slice.aside, v), m = n - axis * glm::dot(n, axis);
    const double g = slice.angle_of(m);
    const double ahead = horizon_angle(image, s, x, y, along * radius_pixels, jitter, v, 0.5 * kPi + g),
                 behind = horizon_angle(image, s, x, y, -along * radius_pixels, jitter, v, 0.5 * kPi - g);
    const double weight = glm::length(m) / s.slices;
    add_light(slice, ahead, kPi, g, weight, hidden);
    add_light(slice, -kPi, -behind, g, weight, hidden);
  }
  return hidden;
}

}  // namespace

HalfVisibility horizon_visibility(const DepthAndNormals& image, const HorizonSettings& s) {
  HalfVisibility half{(image.width + s.step - 1) / s.step, (image.height + s.step - 1) / s.step, {}, {}};
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x) {
      const int full_x = std::min(s.step * x, image.width - 1), full_y = std::min(s.step * y, image.height - 1);
      const auto i = static_cast<std::size_t>(full_y * image.width + full_x);
      half.visibility.push_back(1.0);
      half.bend.emplace_back(0.0);
      if (image.distance[i] == 0.0 || image.normals[i] == glm::dvec3(0.0)) continue;
      const double resolved =
          std::clamp(s.radius * 0.5 * image.cot_y * image.height / image.distance[i] - 2.0, 0.0, 1.0);
      const double turn = ((x + y) % 4 * 4 + x % 4) / 16.0, jitter = ((y - x + 1024) % 4 + 0.5) / 4.0;
      const Light hidden = hidden_at(image, s, full_x, full_y, turn, jitter);
      const double open = std::clamp(1.0 - resolved * hidden.amount, 0.0, 1.0), visibility = std::pow(open, s.power);
      const double contrast = open < 1.0 ? (1.0 - visibility) / (1.0 - open) : s.power;
      half.visibility.back() = visibility;
      half.bend.back() =
          glm::normalize(image.normals[i] - 1.5 * contrast * resolved * hidden.directed) - image.normals[i];
    }
  return half;
}

}  // namespace sinew::reference
