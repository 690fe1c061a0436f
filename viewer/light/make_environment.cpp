// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "runtime/base/contract.h"
#include "runtime/math/interpolate.h"
#include "runtime/threads/default_executor.h"
#include "viewer/light/environment.h"
#include "viewer/light/reflected_directions.h"

namespace sinew::viewer {
namespace {

constexpr std::uint32_t kDiffuseSize = 32;  // map size for the projection; bands up to 2 contain no finer detail

/// Sample directions per texel of each level: more for wide lobes, whose levels have fewer texels.
constexpr std::array<std::uint32_t, kEnvironmentLevels> kSamples = {1, 16, 48, 128, 384, 1024};

/// Face size of the coarsest pyramid level. Coarser levels are not used: filtering does not cross face edges, so their
/// large texels would make the edges visible.
constexpr std::uint32_t kCoarsest = 8;

/// Squared constants of the real spherical harmonics, times the cosine lobe's factor of their band.
constexpr float kBand0 = 0.079577472f;                    // 1 / (4 pi)
constexpr float kBand1 = 0.238732415f * 2.0f / 3.0f;      // 3 / (4 pi)
constexpr float kBand2 = 1.193662073f * 0.25f;            // 15 / (4 pi)
constexpr float kBand2Zonal = 0.099471839f * 0.25f;       // 5 / (16 pi)
constexpr float kBand2Difference = 0.298415518f * 0.25f;  // 15 / (16 pi)

std::array<float, 9> basis(const glm::vec3& d) noexcept {
  return {1.0f, d.y, d.z, d.x, d.x * d.y, d.y * d.z, 3.0f * d.z * d.z - 1.0f, d.x * d.z, d.x * d.x - d.y * d.y};
}

std::array<glm::vec3, 9> project(const CubeMap& cube) {
  std::array<glm::dvec3, 9> sums{};
  double angle = 0.0;
  std::size_t at = 0;
  for (std::uint32_t face = 0; face < kCubeFaces; ++face)
    for (std::uint32_t y = 0; y < cube.size; ++y)
      for (std::uint32_t x = 0; x < cube.size; ++x) {
        const float weight = texel_solid_angle(x, y, cube.size);
        const std::array<float, 9> values = basis(texel_direction(face, x, y, cube.size));
        for (std::size_t k = 0; k < 9; ++k) sums[k] += glm::dvec3(cube.texels[at] * (weight * values[k]));
        angle += static_cast<double>(weight);
        ++at;
      }
  constexpr std::array<float, 9> constants = {kBand0, kBand1,      kBand1, kBand1,          kBand2,
                                              kBand2, kBand2Zonal, kBand2, kBand2Difference};
  std::array<glm::vec3, 9> diffuse{};
  for (std::size_t k = 0; k < 9; ++k) diffuse[k] = glm::vec3(sums[k] * (4.0 * std::numbers::pi / angle)) * constants[k];
  return diffuse;
}

/// The mip pyramid of a map.
std::vector<CubeMap> pyramid(CubeMap cube) {
  std::vector<CubeMap> levels;
  levels.push_back(std::move(cube));
  while (levels.back().size > kCoarsest) levels.push_back(halved(levels.back()));
  return levels;
}

glm::vec3 sample(std::span<const CubeMap> levels, const glm::vec3& direction, float level) noexcept {
  const float at = std::clamp(level, 0.0f, static_cast<float>(levels.size() - 1));
  const auto first = static_cast<std::size_t>(at);
  const std::size_t second = std::min(first + 1, levels.size() - 1);
  return lerp(sample(levels[first], direction), sample(levels[second], direction), at - static_cast<float>(first));
}

/// Computes one texel of a level: the weighted mean over the reflected directions. Each sample reads the source level
/// whose texels match its solid angle.
glm::vec3 filtered(std::span<const CubeMap> source, std::span<const ReflectedDirection> directions,
                   const glm::vec3& n) noexcept {
  const glm::vec3 aside = glm::normalize(std::abs(n.y) < 0.99f ? glm::cross(n, {0, 1, 0}) : glm::cross(n, {1, 0, 0}));
  const glm::vec3 up = glm::cross(aside, n);
  glm::vec3 sum(0.0f);
  float weights = 0.0f;
  for (const ReflectedDirection& sampled : directions) {
    const glm::vec3& l = sampled.direction;
    sum += l.z * sample(source, aside * l.x + up * l.y + n * l.z, sampled.source_level);
    weights += l.z;
  }
  return sum / weights;
}

CubeMap filtered_level(std::span<const CubeMap> source, std::uint32_t level) {
  const float roughness = static_cast<float>(level) / static_cast<float>(kEnvironmentLevels - 1);
  const std::uint32_t size = source[0].size >> level;
  const auto directions = reflected_directions(roughness, kSamples[level], source[0].size);
  CubeMap cube{size, std::vector<glm::vec3>(std::size_t{kCubeFaces} * size * size)};
  run_in_parallel(kCubeFaces * size, [&](std::size_t item) {
    const auto row = static_cast<std::uint32_t>(item);
    for (std::uint32_t x = 0; x < size; ++x)
      cube.texels[std::size_t{row} * size + x] =
          filtered(source, directions, texel_direction(row / size, x, row % size, size));
  });
  return cube;
}

}  // namespace

std::shared_ptr<Environment> make_environment(CubeMap sky) {
  CONTRACT(sky.size >= 1u << (kEnvironmentLevels - 1));
  const std::vector<CubeMap> source = pyramid(std::move(sky));
  auto made = std::make_shared<Environment>();
  const auto coarse =
      std::find_if(source.begin(), source.end(), [](const CubeMap& c) { return c.size <= kDiffuseSize; });
  made->diffuse = project(*coarse);
  made->reflected.push_back(source[0]);
  for (std::uint32_t level = 1; level < kEnvironmentLevels; ++level)
    made->reflected.push_back(filtered_level(source, level));
  return made;
}

}  // namespace sinew::viewer
