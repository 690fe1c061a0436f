// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <memory>
#include <vector>

#include <glm/vec2.hpp>

#include "viewer/light/cube_map.h"

namespace sinew::viewer {

/// Levels of an environment for reflections. Level i is filtered for the roughness i / (kEnvironmentLevels - 1).
inline constexpr std::uint32_t kEnvironmentLevels = 6;

/// Light that comes from far away, from every direction, as the shaders need it.
struct Environment {
  /// Diffuse light: irradiance / pi of a surface with unit normal (x, y, z) is the sum of these times
  /// 1, y, z, x, xy, yz, 3 z^2 - 1, xz, x^2 - y^2.
  /// eq   Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment Maps" (2001): spherical
  ///      harmonics of order 3, times 1, 2/3 and 1/4 for the bands; the constants of the basis are multiplied in
  std::array<glm::vec3, 9> diffuse{};

  /// Reflected light: [kEnvironmentLevels], each of half the size of the one before.
  /// eq   Karis, "Real Shading in Unreal Engine 4" (2013): sum of L(l) n.l over directions l = reflect(-n, h), where h
  ///      are distributed as GGX with alpha = roughness^2 about n, over the sum of n.l
  std::vector<CubeMap> reflected;

  /// The table of split_sum.h, where it was stored beside the environment; empty = split_sum_table() gives it.
  std::vector<glm::vec3> split_sum;
};

/// Prepares an environment.
/// in   sky  size a power of two, at least 2^(kEnvironmentLevels - 1)
/// cost some 3 million reads of the map for 256 texels, on all cores
std::shared_ptr<const Environment> make_environment(CubeMap sky);

/// Light that changes evenly with the height of its direction: `ground` from below to `sky` from above.
struct Gradient {
  glm::vec3 sky{0.46f, 0.50f, 0.57f}, ground{0.25f, 0.22f, 0.20f};
};

/// A gradient as an environment, by its closed form.
std::shared_ptr<const Environment> gradient_environment(const Gradient& gradient);

/// The default gradient, a cool sky and a warm ground; one object for all.
std::shared_ptr<const Environment> plain_environment();

/// Mean cosine between n and the directions that GGX reflects light from, weighted as `Environment::reflected`: what is
/// left of a gradient.
double mean_reflected_cosine(double roughness);

/// A neutral room with three large soft lights: one above to the front, one aside, one behind.
CubeMap studio_sky();

/// The same as an environment; one object for all.
std::shared_ptr<const Environment> studio_environment();

}  // namespace sinew::viewer
