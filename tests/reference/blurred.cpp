// SPDX-License-Identifier: MIT
#include "tests/reference/blurred.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace sinew::reference {
namespace {

/// Weights of four texels, -1 to 2 from the texel before the point; f = position between texels 0 and 1.
std::array<double, 4> spline_weights(double f) {
  const double g = 1.0 - f;
  return {g * g * g / 6.0, (4.0 - 6.0 * f * f + 3.0 * f * f * f) / 6.0, (4.0 - 6.0 * g * g + 3.0 * g * g * g) / 6.0,
          f * f * f / 6.0};
}

}  // namespace

Layered operator+(const Layered& a, const Layered& b) {
  return {a.light + b.light, a.unlit + b.unlit, a.coverage + b.coverage, a.lit + b.lit};
}

Layered operator*(double factor, const Layered& a) {
  return {factor * a.light, factor * a.unlit, factor * a.coverage, factor * a.lit};
}

const Layered& Blurred::Copy::texel(int x, int y) const {
  const int column = std::clamp(x, 0, width - 1), row = std::clamp(y, 0, height - 1);
  return texels[static_cast<std::size_t>(row * width + column)];
}

Blurred::Copy Blurred::half_of(const Copy& larger) {
  Copy half{std::max(larger.width / 2, 1), std::max(larger.height / 2, 1), {}};
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x) {
      const double at_x = (x + 0.5) * larger.width / half.width - 0.5,
                   at_y = (y + 0.5) * larger.height / half.height - 0.5;
      const int left = static_cast<int>(std::floor(at_x)), top = static_cast<int>(std::floor(at_y));
      const double across = at_x - left, down = at_y - top;
      const auto row = [&](int r) {
        return (1.0 - across) * larger.texel(left, r) + across * larger.texel(left + 1, r);
      };
      half.texels.push_back((1.0 - down) * row(top) + down * row(top + 1));
    }
  return half;
}

Blurred::Blurred(int width, int height, std::vector<Layered> pixels) {
  copies_.push_back({width, height, std::move(pixels)});
  while (copies_.back().width > 1 || copies_.back().height > 1) copies_.push_back(half_of(copies_.back()));
}

Layered Blurred::smooth(const Copy& copy, double x, double y) const {
  const double at_x = x * copy.width / copies_[0].width - 0.5, at_y = y * copy.height / copies_[0].height - 0.5;
  const int left = static_cast<int>(std::floor(at_x)), top = static_cast<int>(std::floor(at_y));
  const std::array columns = spline_weights(at_x - left), rows = spline_weights(at_y - top);
  Layered sum;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c)
      sum = sum + rows[static_cast<std::size_t>(r)] * columns[static_cast<std::size_t>(c)] *
                      copy.texel(left - 1 + c, top - 1 + r);
  return sum;
}

Layered Blurred::bilinear(double x, double y) const {
  const int left = static_cast<int>(std::floor(x - 0.5)), top = static_cast<int>(std::floor(y - 0.5));
  const double across = x - 0.5 - left, down = y - 0.5 - top;
  const auto row = [&](int r) {
    return (1.0 - across) * copies_[0].texel(left, r) + across * copies_[0].texel(left + 1, r);
  };
  return (1.0 - down) * row(top) + down * row(top + 1);
}

Layered Blurred::at(double x, double y, double roughness, bool between) const {
  const auto last = static_cast<double>(copies_.size() - 1);
  const double level = std::min(roughness * std::log2(copies_[0].height), last);
  const auto below = static_cast<std::size_t>(level), above = std::min(below + 1, copies_.size() - 1);
  const Layered exact = between ? bilinear(x, y) : copies_[0].texel(static_cast<int>(x), static_cast<int>(y));
  const Layered fine = below == 0 ? exact : smooth(copies_[below], x, y);
  const double part = level - static_cast<double>(below);
  return (1.0 - part) * fine + part * smooth(copies_[above], x, y);
}

}  // namespace sinew::reference
