// SPDX-License-Identifier: MIT
#include "importer/read/cut_times.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "importer/read/rotations.h"
#include "runtime/math/interpolate.h"

namespace sinew {
namespace {

using KeyRow = std::span<const float>;

/// eq  Hermite cubic and its derivative in time, at the fraction u of an interval of T seconds
///     p(u) = (2u^3 - 3u^2 + 1) a + T (u^3 - 2u^2 + u) a' + (3u^2 - 2u^3) b + T (u^3 - u^2) b'
void split_cubic(KeyRow a, KeyRow a_out, KeyRow b_in, KeyRow b, double u, double interval_s, std::vector<float>& value,
                 std::vector<float>& slope) {
  const double u2 = u * u, u3 = u2 * u, t = interval_s;
  for (std::size_t c = 0; c < a.size(); ++c) {
    const auto from = static_cast<double>(a[c]), to = static_cast<double>(b[c]);
    const auto leave = static_cast<double>(a_out[c]), arrive = static_cast<double>(b_in[c]);
    value.push_back(static_cast<float>((2 * u3 - 3 * u2 + 1) * from + t * (u3 - 2 * u2 + u) * leave +
                                       (3 * u2 - 2 * u3) * to + t * (u3 - u2) * arrive));
    slope.push_back(static_cast<float>((6 * u2 - 6 * u) * (from - to) / t + (3 * u2 - 4 * u + 1) * leave +
                                       (3 * u2 - 2 * u) * arrive));
  }
}

/// Scales a rotation to unit length, as keys must have, and its slope with it.
void make_unit(std::vector<float>& value, std::vector<float>& slope) {
  double square = 0.0;
  for (const float v : value) square += static_cast<double>(v) * static_cast<double>(v);
  if (!(square > 0.0)) return;
  const double scale = 1.0 / std::sqrt(square);
  for (std::vector<float>* part : {&value, &slope})
    for (float& v : *part) v = static_cast<float>(scale * static_cast<double>(v));
}

std::vector<float> split_line(KeyRow a, KeyRow b, double u, bool rotation) {
  if (rotation) {
    const auto quat = [](KeyRow q) { return quat_cast<double>(unit_rotation(q[0], q[1], q[2], q[3]).rotation); };
    const glm::quat q = quat_cast<float>(slerp_short_arc(quat(a), quat(b), u));
    return {q.x, q.y, q.z, q.w};
  }
  std::vector<float> out;
  for (std::size_t c = 0; c < a.size(); ++c)
    out.push_back(static_cast<float>((1.0 - u) * static_cast<double>(a[c]) + u * static_cast<double>(b[c])));
  return out;
}

}  // namespace

std::size_t cut_before_zero(SamplerData& data, bool rotation) {
  std::vector<float>& times = data.times_s;
  const auto first = std::find_if(times.begin(), times.end(), [](float t) { return t >= 0.0f; });
  const auto before = static_cast<std::size_t>(first - times.begin());
  if (before == 0) return 0;
  const bool cubic = data.interpolation == Interpolation::cubic_spline;
  const std::size_t rows = cubic ? 3 : 1, width = data.values.size() / (times.size() * rows);
  const auto row = [&](std::size_t index) { return KeyRow(data.values).subspan(index * width, width); };
  const std::size_t last = before - 1;
  std::vector<float> key;
  if (first == times.end() || (*first > 0.0f && data.interpolation == Interpolation::step)) {
    key.assign(row(last * rows).begin(), row(last * rows).begin() + static_cast<std::ptrdiff_t>(rows * width));
  } else if (*first > 0.0f) {
    const auto begin = static_cast<double>(times[last]);
    const double interval = static_cast<double>(*first) - begin, u = -begin / interval;
    if (cubic) {
      std::vector<float> value, slope;
      split_cubic(row(3 * last + 1), row(3 * last + 2), row(3 * before), row(3 * before + 1), u, interval, value,
                  slope);
      if (rotation) make_unit(value, slope);
      for (const auto* part : {&slope, &value, &slope}) key.insert(key.end(), part->begin(), part->end());
    } else {
      key = split_line(row(last), row(before), u, rotation);
    }
  }
  const std::size_t cut = key.empty() ? before : last;  // a key at 0 replaces the last key before 0
  times.erase(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(cut));
  data.values.erase(data.values.begin(), data.values.begin() + static_cast<std::ptrdiff_t>(cut * rows * width));
  if (!key.empty()) {
    times.front() = 0.0f;
    std::copy(key.begin(), key.end(), data.values.begin());
  }
  return before;
}

}  // namespace sinew
