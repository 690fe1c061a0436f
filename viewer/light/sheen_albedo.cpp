// SPDX-License-Identifier: MIT
#include "viewer/light/sheen_albedo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace sinew::viewer {
namespace {

constexpr int kHeights = 24, kAzimuths = 8;  // of half a circle; the other half is symmetric

constexpr float kGrazingCosine = 1e-4f;

/// The paper's fit of Lambda, interpolated for one roughness.
struct Lambda {
  float a, b, c, d, e;

  explicit Lambda(float alpha) noexcept {
    const float smooth = (1.0f - alpha) * (1.0f - alpha);
    const auto mix = [&](float at_0, float at_1) { return at_1 + (at_0 - at_1) * smooth; };
    a = mix(25.3245f, 21.5473f);
    b = mix(3.32435f, 3.82987f);
    c = mix(0.16801f, 0.19823f);
    d = mix(-1.27393f, -1.97760f);
    e = mix(-4.85967f, -4.32054f);
  }

  float log_at(float x) const noexcept { return a / (1.0f + b * std::pow(x, c)) + d * x + e; }
  float operator()(float x) const noexcept {
    return std::exp(x < 0.5f ? log_at(x) : 2.0f * log_at(0.5f) - log_at(1.0f - x));
  }
};

}  // namespace

float sheen_albedo(float n_v, float roughness) noexcept {
  const float r = std::max(roughness, kLeastSheenRoughness), inverse = 1.0f / (r * r);
  const float v = std::max(n_v, kGrazingCosine), aside = std::sqrt(std::max(0.0f, 1.0f - v * v));
  const Lambda lambda(r * r);
  const float lambda_v = lambda(v);
  float sum = 0.0f;
  for (int i = 0; i < kHeights; ++i) {
    const float u = (static_cast<float>(i) + 0.5f) / kHeights, z = u * u, across = std::sqrt(1.0f - z * z);
    float ring = 0.0f;
    for (int j = 0; j < kAzimuths; ++j) {
      const float turn = std::numbers::pi_v<float> * (static_cast<float>(j) + 0.5f) / kAzimuths;
      const float x = across * std::cos(turn) + aside, y = across * std::sin(turn), h = z + v;
      const float flat = x * x + y * y;
      ring += std::pow(flat / (flat + h * h), 0.5f * inverse);
    }
    // D V n.l, times dz = 2 u du and the angle step of the ring. n.l and pi cancel out.
    sum += ring * (2.0f + inverse) * u / ((1.0f + lambda_v + lambda(z)) * 2.0f * v * kHeights * kAzimuths);
  }
  return sum;
}

}  // namespace sinew::viewer
