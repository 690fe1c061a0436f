// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace sinew {

/// Cosine-distributed directions over the hemisphere of a surface (density cos / pi).
/// eq   cos^2 = (i + shift.x) / count, angle about the normal = 2 pi frac(reversed bits of i + shift.y): Hammersley
///      points with a random shift   (Pharr, Jakob and Humphreys, "Physically Based Rendering": Malley's method;
///      Cranley and Patterson 1976)
class VisibilityRays {
 public:
  /// in   normal  unit;   shift  in [0, 1)
  VisibilityRays(const glm::dvec3& normal, std::uint32_t count, const glm::dvec2& shift)
      : normal_(normal), count_(count), shift_(shift) {
    const glm::dvec3 aside = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    tangent_ = glm::normalize(glm::cross(normal, aside));
    bitangent_ = glm::cross(normal, tangent_);
  }

  glm::dvec3 direction(std::uint32_t i) const {
    std::uint32_t reversed = 0;
    for (int bit = 0; bit < 32; ++bit) reversed |= (i >> bit & 1u) << (31 - bit);
    const double turn = reversed * 0x1p-32 + shift_.y, angle = 2.0 * std::numbers::pi * (turn - std::floor(turn)),
                 cos2 = (i + shift_.x) / count_;
    const glm::dvec3 flat = tangent_ * std::cos(angle) + bitangent_ * std::sin(angle);
    return flat * std::sqrt(1.0 - cos2) + normal_ * std::sqrt(cos2);
  }

 private:
  glm::dvec3 normal_, tangent_{0.0}, bitangent_{0.0};
  std::uint32_t count_;
  glm::dvec2 shift_;
};

/// The random shift of the rays that start at one triangle corner; it depends on the seed and the corner.
/// eq   draws 2c and 2c + 1 of SplitMix64 (Steele, Lea and Flood 2014), started at a multiple of the seed
/// in   corner  c, counted over the indices of all surfaces
inline glm::dvec2 visibility_shift(std::uint64_t seed, std::uint64_t corner) {
  std::uint64_t state = seed * 0xD1342543DE82EF95ull + corner * 2 * 0x9E3779B97F4A7C15ull;
  const auto draw = [&state] {
    std::uint64_t z = state += 0x9E3779B97F4A7C15ull;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  };
  const double x = draw(), y = draw();
  return {x, y};
}

/// Start point of the rays of a corner. Slightly inside the triangle, so that surfaces that meet at the corner lie
/// beside the rays. Above it by more than the rounding error of float coordinates.
/// eq   q = corner + (centroid - corner) / 64;  q + normal * (2^-20 (|q.x| + |q.y| + |q.z|) + 2^-14 |q - corner|)
inline glm::dvec3 visibility_start(const glm::dvec3& corner, const glm::dvec3& centroid, const glm::dvec3& normal) {
  const glm::dvec3 inward = (centroid - corner) * 0x1p-6, q = corner + inward;
  const double size = std::abs(q.x) + std::abs(q.y) + std::abs(q.z);
  return q + normal * (0x1p-20 * size + 0x1p-14 * glm::length(inward));
}

}  // namespace sinew
