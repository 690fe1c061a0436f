// SPDX-License-Identifier: MIT
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "runtime/blend_space/band_numbers.h"
#include "runtime/blend_space/blend_space.h"

namespace sinew {
namespace {

using Points = std::span<const glm::vec2>;

double distance(const glm::vec2& a, const glm::vec2& b) noexcept {
  return std::hypot(double{a.x} - double{b.x}, double{a.y} - double{b.y});
}

void prepare_cartesian(Points points, std::span<double> numbers) {
  double* to = numbers.data();
  std::vector<CartesianPair> pairs(points.size());
  for (const glm::vec2& from : points) {
    std::transform(points.begin(), points.end(), pairs.begin(), [&](const glm::vec2& other) -> CartesianPair {
      const double dx = double{other.x} - double{from.x}, dy = double{other.y} - double{from.y};
      const double length2 = dx * dx + dy * dy;
      if (!(length2 > 0.0)) return {};
      return {dx / length2, dy / length2, std::hypot(dx / length2, dy / length2)};
    });
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const CartesianPair& a, const CartesianPair& b) { return a.length > b.length; });
    for (const CartesianPair& pair : pairs)
      for (const double number : {pair.x, pair.y, pair.length}) *to++ = number;
  }
}

BandPair directional_pair(const BandPoint& from, const BandPoint& to, double factor) noexcept {
  if (from.speed == 0.0 || to.speed == 0.0) return {};
  const double mean = (from.speed + to.speed) / 2.0, rise = (to.speed - from.speed) / mean;
  const double angle = angle_from(from.angle_rad, to.angle_rad);
  const double length2 = factor * angle * factor * angle + rise * rise;
  if (!(length2 > 0.0)) return {};
  const double turn = factor * factor * angle / length2;
  const bool opposite = std::abs(angle) >= kOpposite_rad;
  return {opposite ? 0.0 : turn, opposite ? std::abs(turn) : 0.0, rise / (mean * length2)};
}

void prepare_directional(Points points, double factor, std::span<double> numbers) noexcept {
  const std::size_t count = points.size();
  const auto point = [&](std::size_t i) {
    const double x = double{points[i].x}, y = double{points[i].y};
    return BandPoint{x == 0.0 && y == 0.0 ? 0.0 : std::atan2(y, x), std::hypot(x, y)};
  };
  double least = 0.0;
  bool has_center = false;
  for (std::size_t i = 0; i < count; ++i) {
    const BandPoint p = point(i);
    has_center |= p.speed == 0.0;
    if (p.speed > 0.0) least = least > 0.0 ? std::min(least, p.speed) : p.speed;
    numbers[1 + 2 * i] = p.angle_rad;
    numbers[2 + 2 * i] = p.speed;
  }
  numbers[0] = has_center ? 0.0 : least / 4.0;
  double* to = numbers.data() + 1 + 2 * count;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j) {
      const BandPair pair = directional_pair(point(i), point(j), factor);
      for (const double number : {pair.turn, pair.turn_of_opposite, pair.rise}) *to++ = number;
    }
}

/// Rows of the inverse of A (blend_space_weights), computed without duplicate points. Points at the same place get
/// equal parts of one row.
void prepare_radial(Points points, std::span<double> numbers) {
  const std::size_t count = points.size();
  std::vector<std::size_t> firsts, place(count);  // first point at each place; index into `firsts` for each point
  std::vector<double> sharers;
  for (std::size_t i = 0; i < count; ++i) {
    const auto first =
        std::find_if(firsts.begin(), firsts.end(), [&](std::size_t f) { return points[f] == points[i]; });
    place[i] = static_cast<std::size_t>(first - firsts.begin());
    if (first == firsts.end()) {
      firsts.push_back(i);
      sharers.push_back(0.0);
    }
    ++sharers[place[i]];
  }
  const auto places = static_cast<Eigen::Index>(firsts.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Ones(places + 1, places + 1);
  a(places, places) = 0.0;
  for (Eigen::Index i = 0; i < places; ++i)
    for (Eigen::Index j = 0; j < places; ++j)
      a(i, j) = distance(points[firsts[std::size_t(i)]], points[firsts[std::size_t(j)]]);
  const Eigen::MatrixXd inverse = a.fullPivLu().inverse();
  std::fill(numbers.begin(), numbers.end(), 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    double* const row = numbers.data() + i * (count + 1);
    const auto of = static_cast<Eigen::Index>(place[i]);
    for (Eigen::Index j = 0; j < places; ++j) row[firsts[std::size_t(j)]] = inverse(of, j) / sharers[place[i]];
    row[count] = inverse(of, places) / sharers[place[i]];
  }
}

}  // namespace

std::size_t blend_space_numbers(BlendSpaceKind kind, std::size_t points) noexcept {
  switch (kind) {
    case BlendSpaceKind::cartesian: return 3 * points * points;
    case BlendSpaceKind::directional: return 1 + 2 * points + 3 * points * points;
    case BlendSpaceKind::radial: return points * (points + 1);
    default: return 0;
  }
}

ErrorCode prepare_blend_space(BlendSpaceKind kind, std::span<const glm::vec2> points, float angle_factor,
                              std::span<double> numbers) {
  constexpr float kLargest = 1e9f;
  if (points.empty() || points.size() > kMostBlendPoints || numbers.size() != blend_space_numbers(kind, points.size()))
    return ErrorCode::size_mismatch;
  for (const glm::vec2& point : points) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) return ErrorCode::not_finite;
    if (std::abs(point.x) > kLargest || std::abs(point.y) > kLargest) return ErrorCode::too_large;
  }
  if (!std::isfinite(angle_factor)) return ErrorCode::not_finite;
  if (!(angle_factor > 0.0f)) return ErrorCode::not_a_fraction;
  if (kind == BlendSpaceKind::cartesian) prepare_cartesian(points, numbers);
  if (kind == BlendSpaceKind::directional) prepare_directional(points, double{angle_factor}, numbers);
  if (kind == BlendSpaceKind::radial) prepare_radial(points, numbers);
  return ErrorCode::ok;
}

}  // namespace sinew
