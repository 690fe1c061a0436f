// SPDX-License-Identifier: MIT
#include "viewer/light/reflected_directions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sinew::viewer {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// Added to the source level, so that neighbouring samples overlap and a low sample count leaves no pattern.
constexpr float kOverlap = 0.5f;

/// Radical inverse of i in base 2 (van der Corput sequence), in [0, 1).
float reversed_bits(std::uint32_t i) noexcept {
  float sum = 0.0f;
  for (float digit = 0.5f; i > 0; i /= 2) {
    if (i % 2 == 1) sum += digit;
    digit *= 0.5f;
  }
  return sum;
}

}  // namespace

std::vector<ReflectedDirection> reflected_directions(float roughness, std::uint32_t count, std::uint32_t source_size) {
  const float alpha = roughness * roughness, alpha2 = alpha * alpha;
  const float texel = 4.0f * kPi / (static_cast<float>(kCubeFaces) * static_cast<float>(source_size * source_size));
  std::vector<ReflectedDirection> directions;
  for (std::uint32_t i = 0; i < count; ++i) {
    const float s = (static_cast<float>(i) + 0.5f) / static_cast<float>(count), turn = 2.0f * kPi * reversed_bits(i);
    const float cos2 = (1.0f - s) / (1.0f + (alpha2 - 1.0f) * s);
    const float z = 2.0f * cos2 - 1.0f;  // z of the reflected direction: cos(2 angle)
    if (z <= 0.0f) continue;
    const float r = std::sqrt(std::max(0.0f, 1.0f - z * z));
    const float d = cos2 * (alpha2 - 1.0f) + 1.0f, density = alpha2 / (kPi * d * d) / 4.0f;
    const float share = 1.0f / (static_cast<float>(count) * density);
    directions.push_back(
        {{r * std::cos(turn), r * std::sin(turn), z}, std::max(0.0f, 0.5f * std::log2(share / texel) + kOverlap)});
  }
  return directions;
}

}  // namespace sinew::viewer
