// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "runtime/math/conventions.h"

namespace sinew::reference {

using Places = std::span<const glm::dvec2>;

inline std::vector<double> with_sum_1(std::vector<double> h) {
  double sum = 0.0;
  for (const double x : h) sum += x;
  for (double& x : h) x /= sum;
  return h;
}

/// Gradient bands (Johansen 2009, 6.3).
inline std::vector<double> cartesian_weights(Places points, glm::dvec2 p) {
  std::vector<double> h;
  for (const glm::dvec2& a : points) {
    h.push_back(1.0);
    for (const glm::dvec2& b : points)
      if (a != b) h.back() = std::min(h.back(), std::clamp(1.0 - dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0));
  }
  return with_sum_1(h);
}

/// Angle from a to b with its sign, in (-pi, pi].
inline double signed_angle(glm::dvec2 a, glm::dvec2 b) { return std::atan2(a.x * b.y - a.y * b.x, dot(a, b)); }

/// Gradient bands in polar form (Johansen 2009, 6.3.2), with the rules of blend_space.h for the origin.
inline std::vector<double> directional_weights(Places points, glm::dvec2 p, double factor) {
  double least = 0.0;
  bool has_center = false;
  for (const glm::dvec2& a : points) {
    if (length(a) == 0.0)
      has_center = true;
    else if (least == 0.0 || length(a) < least)
      least = length(a);
  }
  const double speed = length(p), kept = has_center ? 1.0 : std::min(1.0, speed / (least / 4.0));
  std::vector<double> h;
  for (const glm::dvec2& a : points) {
    h.push_back(1.0);
    for (const glm::dvec2& b : points) {
      if (a == b) continue;
      const double mean = (length(a) + length(b)) / 2.0;
      double to_b = 0.0, to_p = 0.0;  // angles from a
      if (length(a) == 0.0) {
        to_b = speed > 0.0 ? signed_angle(p, b) : 0.0;
      } else if (length(b) == 0.0) {
        to_b = to_p = speed > 0.0 ? signed_angle(a, p) : 0.0;
      } else {
        to_b = signed_angle(a, b);
        to_p = speed > 0.0 ? signed_angle(a, p) * kept : 0.0;
        if (std::abs(to_b) >= 0.99 * std::numbers::pi) {
          to_b = std::abs(to_b);
          to_p = std::abs(to_p);
        }
      }
      const glm::dvec2 ab(factor * to_b, (length(b) - length(a)) / mean), ap(factor * to_p, (speed - length(a)) / mean);
      if (dot(ab, ab) > 0.0) h.back() = std::min(h.back(), std::clamp(1.0 - dot(ap, ab) / dot(ab, ab), 0.0, 1.0));
    }
  }
  return with_sum_1(h);
}

/// Solves a system by Gauss and Jordan, pivoting by rows.
inline std::vector<double> solution(std::vector<std::vector<double>> a, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c; r < n; ++r)
      if (std::abs(a[r][c]) > std::abs(a[pivot][c])) pivot = r;
    std::swap(a[c], a[pivot]);
    std::swap(b[c], b[pivot]);
    for (std::size_t r = 0; r < n; ++r) {
      if (r == c) continue;
      const double by = a[r][c] / a[c][c];
      for (std::size_t k = c; k < n; ++k) a[r][k] -= by * a[c][k];
      b[r] -= by * b[c];
    }
  }
  for (std::size_t c = 0; c < n; ++c) b[c] /= a[c][c];
  return b;
}

/// Radial basis functions of the distance that sum to 1, without negative parts.     in   points  all apart
inline std::vector<double> radial_weights(Places points, glm::dvec2 p) {
  const std::size_t n = points.size();
  std::vector<std::vector<double>> a(n + 1, std::vector<double>(n + 1, 1.0));
  std::vector<double> b(n + 1, 1.0);
  for (std::size_t i = 0; i < n; ++i) {
    b[i] = distance(p, points[i]);
    for (std::size_t j = 0; j < n; ++j) a[i][j] = distance(points[i], points[j]);
  }
  a[n][n] = 0.0;
  std::vector<double> w = solution(a, b);
  w.pop_back();
  for (double& x : w) x = std::max(x, 0.0);
  return with_sum_1(w);
}

}  // namespace sinew::reference
