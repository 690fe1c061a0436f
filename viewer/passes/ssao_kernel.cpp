// SPDX-License-Identifier: MIT
#include "viewer/passes/ssao_kernel.h"

#include <cmath>
#include <cstdint>
#include <numbers>

#include "runtime/base/contract.h"

namespace sinew::viewer {

namespace {

constexpr std::uint64_t kSeed = 0x51e2d5a0;

/// SplitMix64. The distributions of <random> give different numbers on different platforms.
class Random {
 public:
  float in(float lower, float upper) noexcept {
    state_ += 0x9e3779b97f4a7c15ull;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    const auto top_bits = static_cast<float>((z ^ (z >> 31)) >> 40);  // 24 bits: exact in a float
    return lower + (upper - lower) * (top_bits / 16777216.0f);
  }

 private:
  std::uint64_t state_ = kSeed;
};

glm::vec3 scaled_to(const glm::vec3& v, float length) {
  return v * (length / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z));
}

/// Directions that represent lines: no direction is the opposite of another.
/// eq   more than seven: height (i + 1/2) / count, angle i times the golden angle   (Swinbank and Purser 2006)
std::vector<glm::vec3> lines(std::size_t count) {
  constexpr std::array<glm::vec3, 7> of_cube = {
      {{1, 1, 1}, {-1, 1, 1}, {1, 1, -1}, {-1, 1, -1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
  if (count <= of_cube.size()) return {of_cube.begin(), of_cube.begin() + static_cast<std::ptrdiff_t>(count)};
  std::vector<glm::vec3> spiral;
  for (std::size_t i = 0; i < count; ++i) {
    const double height = (static_cast<double>(i) + 0.5) / static_cast<double>(count),
                 width = std::sqrt(1.0 - height * height);
    const double angle = std::numbers::pi * (3.0 - std::sqrt(5.0)) * static_cast<double>(i);
    spiral.emplace_back(glm::dvec3(width * std::cos(angle), height, width * std::sin(angle)));
  }
  return spiral;
}

}  // namespace

SsaoKernel make_ssao_kernel(std::uint32_t samples) {
  CONTRACT(samples >= 2 && samples % 2 == 0 && samples <= kMostOcclusionSamples);
  Random random;
  SsaoKernel kernel{};
  for (const glm::vec3& line : lines(samples / 2)) {
    kernel.offsets.push_back(scaled_to(line, random.in(0.25f, 1.0f)));
    kernel.offsets.push_back(scaled_to(-line, random.in(0.25f, 1.0f)));
  }
  for (glm::vec3& mirror : kernel.noise) {
    glm::vec3 v(0.0f);  // rejection sampling: uniform in the ball, so uniform in direction
    float squared = 0.0f;
    do {
      v.x = random.in(-1.0f, 1.0f);
      v.y = random.in(-1.0f, 1.0f);
      v.z = random.in(-1.0f, 1.0f);
      squared = v.x * v.x + v.y * v.y + v.z * v.z;
    } while (squared > 1.0f || squared < 0.01f);
    mirror = scaled_to(v, 1.0f);
  }
  return kernel;
}

}  // namespace sinew::viewer
