// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/blend_space/band_numbers.h"
#include "runtime/blend_space/blend_space.h"

namespace sinew {
namespace {

using Influences = std::array<double, kMostBlendPoints>;

void weigh_line(std::span<const glm::vec2> points, float x, Influences& h) noexcept {
  double below = -HUGE_VAL, above = HUGE_VAL, least = HUGE_VAL, most = -HUGE_VAL;
  for (const glm::vec2& point : points) {
    const double at = double{point.x};
    least = std::min(least, at);
    most = std::max(most, at);
    if (at <= double{x}) below = std::max(below, at);
    if (at >= double{x}) above = std::min(above, at);
  }
  if (below < least) below = above = least;
  if (above > most) below = above = most;
  double at_below = 0.0, at_above = 0.0;  // numbers of points at the same place
  for (const glm::vec2& point : points) {
    at_below += double{point.x} == below ? 1.0 : 0.0;
    at_above += double{point.x} == above ? 1.0 : 0.0;
  }
  const double share = above > below ? (double{x} - below) / (above - below) : 1.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double at = double{points[i].x};
    h[i] = at == above ? share / at_above : at == below ? (1.0 - share) / at_below : 0.0;
  }
}

void weigh_cartesian(const BlendSpace& space, double x, double y, Influences& h) noexcept {
  const std::size_t count = space.points.size();
  const double* pairs = space.numbers.data();
  constexpr double kRounding = 1.0 + 1e-12;
  for (std::size_t i = 0; i < count; ++i, pairs += 3 * count) {
    const double dx = x - double{space.points[i].x}, dy = y - double{space.points[i].y};
    const double reach = std::sqrt(dx * dx + dy * dy) * kRounding;
    double most = 0.0;  // largest share of the way to another point
    // No later pair has a larger share. The last pair is that of the point with itself, whose length is 0.
    for (const double* pair = pairs; most < 1.0 && reach * pair[2] > most; pair += 3)
      most = std::max(most, dx * pair[0] + dy * pair[1]);
    h[i] = std::max(1.0 - most, 0.0);
  }
}

/// The way from a point towards the origin, or from the origin towards a point.
/// in   turn  angle between point and place, times its factor
double way_to_origin(double turn, double speed, double of_point) noexcept {
  return (turn * turn + 4.0 * (of_point - speed) / of_point) / (turn * turn + 4.0);
}
double way_from_origin(double turn, double speed, double of_point) noexcept {
  return 4.0 * speed / of_point / (turn * turn + 4.0);
}

void weigh_directional(const BlendSpace& space, double x, double y, Influences& h) noexcept {
  const std::size_t count = space.points.size();
  const double* const numbers = space.numbers.data();
  const double speed = std::sqrt(x * x + y * y), direction = speed > 0.0 ? std::atan2(y, x) : 0.0;
  const bool has_center = numbers[0] == 0.0;
  const double kept_turn = speed < numbers[0] ? speed / numbers[0] : 1.0, factor = double{space.angle_factor};
  const auto point = [&](std::size_t i) { return BandPoint{numbers[1 + 2 * i], numbers[2 + 2 * i]}; };
  const auto turn_of = [&](const BandPoint& p) { return speed > 0.0 ? angle_from(p.angle_rad, direction) : 0.0; };
  const double* pair = numbers + 1 + 2 * count;
  for (std::size_t i = 0; i < count; ++i) {
    const BandPoint from = point(i);
    const double turn = turn_of(from) * kept_turn, opposite_turn = std::abs(turn), rise = speed - from.speed;
    double most = 0.0;
    if (from.speed > 0.0) {
      for (std::size_t j = 0; j < count; ++j, pair += 3)
        most = std::max(most, turn * pair[0] + opposite_turn * pair[1] + rise * pair[2]);
      if (has_center) most = std::max(most, way_to_origin(factor * turn, speed, from.speed));
    } else {
      for (std::size_t j = 0; j < count; ++j, pair += 3)
        if (const BandPoint to = point(j); to.speed > 0.0)
          most = std::max(most, way_from_origin(factor * turn_of(to), speed, to.speed));
    }
    h[i] = std::max(1.0 - most, 0.0);
  }
}

void weigh_radial(const BlendSpace& space, double x, double y, Influences& h) noexcept {
  const std::size_t count = space.points.size();
  std::array<double, kMostBlendPoints> distances;
  for (std::size_t j = 0; j < count; ++j) {
    const double dx = x - double{space.points[j].x}, dy = y - double{space.points[j].y};
    distances[j] = std::sqrt(dx * dx + dy * dy);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const double* const row = space.numbers.data() + i * (count + 1);
    double weight = row[count];
    for (std::size_t j = 0; j < count; ++j) weight += row[j] * distances[j];
    h[i] = std::max(weight, 0.0);
  }
}

/// Gives all weight to the nearest point. Used where no point has an influence.
void weigh_nearest(std::span<const glm::vec2> points, double x, double y, Influences& h) noexcept {
  const auto distance2 = [&](const glm::vec2& p) {
    const double dx = x - double{p.x}, dy = y - double{p.y};
    return dx * dx + dy * dy;
  };
  const auto nearest = std::min_element(points.begin(), points.end(), [&](const glm::vec2& a, const glm::vec2& b) {
    return distance2(a) < distance2(b);
  });
  h[static_cast<std::size_t>(nearest - points.begin())] = 1.0;
}

}  // namespace

void blend_space_weights(const BlendSpace& space, float x, float y, std::span<float> weights) noexcept {
  Influences h;
  switch (space.kind) {
    case BlendSpaceKind::line: weigh_line(space.points, x, h); break;
    case BlendSpaceKind::cartesian: weigh_cartesian(space, double{x}, double{y}, h); break;
    case BlendSpaceKind::directional: weigh_directional(space, double{x}, double{y}, h); break;
    case BlendSpaceKind::radial: weigh_radial(space, double{x}, double{y}, h); break;
  }
  const auto total = [&] {
    double sum = 0.0;
    for (std::size_t i = 0; i < space.points.size(); ++i) sum += h[i];
    return sum;
  };
  double sum = total();
  if (!(sum > 1e-9)) {
    weigh_nearest(space.points, double{x}, double{y}, h);
    sum = total();
  }
  for (std::size_t i = 0; i < space.points.size(); ++i) weights[i] = static_cast<float>(h[i] / sum);
}

}  // namespace sinew
