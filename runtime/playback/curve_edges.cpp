// SPDX-License-Identifier: MIT
#include "runtime/playback/curve_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sinew {
namespace {

/// A cubic piece of a curve, as a polynomial of u in [0, 1]: ((a u + b) u + c) u + d.
struct Cubic {
  double a, b, c, d;

  Cubic(const CurveKey<float>& from, const CurveKey<float>& to, double interval) {
    const double v0 = from.value, v1 = to.value, m0 = interval * from.out_tangent, m1 = interval * to.in_tangent;
    a = 2.0 * (v0 - v1) + m0 + m1;
    b = 3.0 * (v1 - v0) - 2.0 * m0 - m1;
    c = m0;
    d = v0;
  }
  double at(double u) const noexcept { return ((a * u + b) * u + c) * u + d; }

  /// Calls `body(u0, u1)` for pieces between which the slope does not change its sign, in their order.
  template <class Body>
  void for_each_monotone_piece(const Body& body) const {
    std::array<double, 4> cuts = {0.0, 1.0, 1.0, 1.0};
    std::size_t count = 1;
    const auto cut = [&](double u) {
      if (u > cuts[count - 1] && u < 1.0) cuts[count++] = u;
    };
    const double p = 3.0 * a, q = b, discriminant = q * q - p * c;  // roots of p u^2 + 2 q u + c
    if (discriminant > 0.0) {
      const double r = -(q + std::copysign(std::sqrt(discriminant), q));  // no cancellation
      const double u0 = p != 0.0 ? r / p : 2.0, u1 = r != 0.0 ? c / r : 2.0;
      cut(std::min(u0, u1));
      cut(std::max(u0, u1));
    }
    cuts[count] = 1.0;
    for (std::size_t i = 0; i < count; ++i) body(cuts[i], cuts[i + 1]);
  }
};

/// Collects edges within a clip, in the order of time.
class EdgeFinder {
 public:
  EdgeFinder(double threshold, double duration_s) noexcept : threshold_(threshold), duration_s_(duration_s) {}

  bool is_above(double value) const noexcept { return value > threshold_; }

  void cross(double time_s, bool rises) {
    if (time_s <= 0.0 || time_s > duration_s_) return;
    edges_.times_s.push_back(time_s);
    edges_.rises.push_back(rises);
  }

  /// Adds edges between two keys at different times. The first key does not hold its value.
  void follow(const CurveKey<float>& from, const CurveKey<float>& to) {
    const double begin = from.time_s, interval = to.time_s - begin;
    if (from.step == CurveStep::linear) {
      const double v0 = from.value, v1 = to.value;
      if (is_above(v0) != is_above(v1)) cross(begin + (threshold_ - v0) / (v1 - v0) * interval, is_above(v1));
    } else {
      const Cubic cubic(from, to, interval);
      cubic.for_each_monotone_piece([&](double u0, double u1) {
        // At the ends the keys count, as in sample(): the polynomial rounds there.
        const bool above0 = is_above(u0 == 0.0 ? from.value : cubic.at(u0));
        const bool above1 = is_above(u1 == 1.0 ? to.value : cubic.at(u1));
        if (above0 != above1) cross(begin + bisect(cubic, u0, u1, above0) * interval, above1);
      });
    }
  }

  void jump(double time_s, double before, double after) {
    if (is_above(before) != is_above(after)) cross(time_s, is_above(after));
  }

  /// Adds the edge at the seam of a loop, where the beginning follows the end.
  void close(bool end_is_above, bool begin_is_above) {
    if (end_is_above == begin_is_above) return;
    edges_.times_s.insert(edges_.times_s.begin(), 0.0);
    edges_.rises.insert(edges_.rises.begin(), begin_is_above);
  }

  CurveEdges take() { return std::move(edges_); }

 private:
  double bisect(const Cubic& cubic, double low, double high, bool low_is_above) const noexcept {
    for (int i = 0; i < 64; ++i) {
      const double middle = low + 0.5 * (high - low);
      (is_above(cubic.at(middle)) == low_is_above ? low : high) = middle;
    }
    return high;
  }

  double threshold_, duration_s_;
  CurveEdges edges_;
};

}  // namespace

CurveEdges find_edges(Curve<float> keys, float threshold, double duration_s, bool loops) {
  EdgeFinder finder(static_cast<double>(threshold), duration_s);
  // Keys at one time: the curve arrives at the first of them and leaves from the last.
  const auto last_at_time_of = [&](std::size_t k) {
    while (k + 1 < keys.size() && keys[k + 1].time_s == keys[k].time_s) ++k;
    return k;
  };
  std::size_t k = last_at_time_of(0);
  finder.jump(keys.front().time_s, keys.front().value, keys[k].value);
  while (k + 1 < keys.size()) {
    const std::size_t next = k + 1, last = last_at_time_of(next);
    const bool holds = keys[k].step == CurveStep::hold;
    if (!holds) finder.follow(keys[k], keys[next]);
    finder.jump(keys[next].time_s, keys[holds ? k : next].value, keys[last].value);
    k = last;
  }
  if (loops)
    finder.close(finder.is_above(static_cast<double>(sample(keys, duration_s))),
                 finder.is_above(static_cast<double>(sample(keys, 0.0))));
  return finder.take();
}

CurveEdges find_edges(Curve<bool> keys, double duration_s, bool loops) {
  std::vector<CurveKey<float>> numbers;
  for (const CurveKey<bool>& key : keys)
    numbers.push_back({key.time_s, CurveStep::hold, key.value ? 1.0f : 0.0f, 0.0f, 0.0f});
  return find_edges(Curve<float>(numbers), 0.5f, duration_s, loops);
}

}  // namespace sinew
