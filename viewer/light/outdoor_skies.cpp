// SPDX-License-Identifier: MIT
#include "viewer/light/outdoor_skies.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "runtime/math/interpolate.h"

namespace sinew::viewer {
namespace {

constexpr std::uint32_t kCloudSeed = 2166136261u;
constexpr float kHorizonBlur = 0.06f;  // sine of the angle over which sky turns into ground

/// A number in [0, 1) for each corner of an integer grid.
/// eq   Jarzynski and Olano, "Hash Functions for GPU Rendering" (2020): pcg3d, first output
float at_corner(std::int32_t x, std::int32_t y, std::int32_t z) noexcept {
  const auto mixed = [](std::uint32_t v) { return v * 1664525u + 1013904223u; };
  std::uint32_t a = mixed(static_cast<std::uint32_t>(x) ^ kCloudSeed), b = mixed(static_cast<std::uint32_t>(y)),
                c = mixed(static_cast<std::uint32_t>(z));
  a += b * c;
  b += c * a;
  c += a * b;
  a ^= a >> 16;
  b ^= b >> 16;
  c ^= c >> 16;
  return static_cast<float>((a + b * c) >> 8) / 16777216.0f;
}

/// Smooth noise in [0, 1) with one corner value a unit.
float noise(const glm::vec3& p) noexcept {
  const glm::vec3 first = glm::floor(p), part = p - first, share = part * part * (3.0f - 2.0f * part);
  const auto x = static_cast<std::int32_t>(first.x), y = static_cast<std::int32_t>(first.y),
             z = static_cast<std::int32_t>(first.z);
  const auto row = [&](std::int32_t dy, std::int32_t dz) {
    return lerp(at_corner(x, y + dy, z + dz), at_corner(x + 1, y + dy, z + dz), share.x);
  };
  return lerp(lerp(row(0, 0), row(1, 0), share.y), lerp(row(0, 1), row(1, 1), share.y), share.z);
}

/// Noise of four octaves, with mean 1/2.
float clouds(glm::vec3 p) noexcept {
  float sum = 0.0f, weight = 8.0f / 15.0f;
  for (int octave = 0; octave < 4; ++octave) {
    sum += weight * noise(p);
    p = 2.0f * p + 17.0f;
    weight *= 0.5f;
  }
  return sum;
}

/// The point of a layer of clouds above the viewer that is seen in a direction. It ends at a finite distance.
glm::vec3 in_cloud_layer(const glm::vec3& d) noexcept {
  const float height = std::max(d.y, 0.0f) + 0.12f;
  return {d.x / height, 0.0f, d.z / height};
}

/// Mixes sky and ground at the horizon.
glm::vec3 over_ground(const glm::vec3& d, const glm::vec3& sky, const glm::vec3& ground) noexcept {
  return lerp(ground, sky, glm::smoothstep(-kHorizonBlur, kHorizonBlur, d.y));
}

}  // namespace

glm::vec3 sunset_radiance(const glm::vec3& d) {
  constexpr glm::vec3 zenith(0.20f, 0.31f, 0.56f), far(0.50f, 0.42f, 0.47f), near(1.55f, 0.84f, 0.38f),
      glow(5.0f, 2.9f, 1.2f), cloud(1.30f, 0.78f, 0.52f), ground(0.20f, 0.165f, 0.13f);
  const glm::vec3 to_sun = glm::normalize(kSun.to_light);
  const float facing = 0.5f + 0.5f * glm::dot(d, to_sun);
  const glm::vec3 horizon = lerp(far, near, facing * facing);
  glm::vec3 sky = lerp(horizon, zenith, std::sqrt(std::clamp(d.y, 0.0f, 1.0f)));
  const float covered = glm::smoothstep(0.48f, 0.72f, clouds(1.7f * in_cloud_layer(d)));
  sky = lerp(sky, cloud * (0.35f + 0.65f * facing), 0.7f * covered);
  sky += glow * std::exp(-28.0f * (1.0f - glm::dot(d, to_sun)));
  const float grass = 0.8f + 0.4f * clouds(9.0f * d);
  return over_ground(d, sky, ground * grass * (0.7f + 0.6f * facing));
}

glm::vec3 overcast_radiance(const glm::vec3& d) {
  constexpr glm::vec3 zenith(1.28f, 1.32f, 1.38f), ground(0.27f, 0.26f, 0.25f);
  const float depth = 0.86f + 0.28f * clouds(1.3f * in_cloud_layer(d));
  const glm::vec3 sky = zenith * ((1.0f + 2.0f * std::max(d.y, 0.0f)) / 3.0f * depth);
  return over_ground(d, sky, ground * (0.85f + 0.3f * clouds(9.0f * d)));
}

}  // namespace sinew::viewer
