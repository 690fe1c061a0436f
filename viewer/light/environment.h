// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "viewer/light/cube_map.h"

namespace sinew::viewer {

/// Number of mip levels of the reflection map. Level i is prefiltered for roughness i / (kEnvironmentLevels - 1).
inline constexpr std::uint32_t kEnvironmentLevels = 6;

/// A directional light that casts the shadows of an environment, for scenes without lights of their own.
struct KeyLight {
  glm::vec3 to_light;    ///< world space, any length except 0
  glm::vec3 irradiance;  ///< linear, on a surface that faces the light; 0 = there is no such light
};

/// Distant environment light, prefiltered for the shaders.
struct Environment {
  /// Diffuse light: irradiance / pi at unit normal (x, y, z) is the dot product of these coefficients with (1, y, z, x,
  /// xy, yz, 3 z^2 - 1, xz, x^2 - y^2).
  /// eq   Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment Maps" (2001): spherical
  ///      harmonics up to band 2, scaled by 1, 2/3 and 1/4 for the bands; the basis constants are included
  std::array<glm::vec3, 9> diffuse{};

  /// Specular light: [kEnvironmentLevels] mip levels, each half the size of the one before.
  /// eq   Karis, "Real Shading in Unreal Engine 4" (2013): sum(L(l) n.l) / sum(n.l) over directions l = reflect(-n, h),
  ///      with h distributed as GGX about n, alpha = roughness^2
  std::vector<CubeMap> reflected;

  /// The table of split_sum.h, if it was loaded from the disk cache; empty = use split_sum_table().
  std::vector<glm::vec3> split_sum;

  std::optional<KeyLight> key;  ///< unset = the default key light (Lighting)
  float backdrop = 1.0f;        ///< brightness of the environment where it is seen behind the scene
};

/// Prefilters a sky into an environment.
/// in   sky  size a power of two, at least 2^(kEnvironmentLevels - 1)
/// cost about 3 million map reads for a 256-texel cube, on all cores
std::shared_ptr<Environment> make_environment(CubeMap sky);

/// Radiance linear in the y of its direction: `ground` at -1, `sky` at +1.
struct Gradient {
  glm::vec3 sky{0.46f, 0.50f, 0.57f}, ground{0.25f, 0.22f, 0.20f};
};

/// The environment of a gradient, computed in closed form.
std::shared_ptr<const Environment> gradient_environment(const Gradient& gradient);

/// The environment of the default gradient, a cool sky and a warm ground. A shared singleton.
std::shared_ptr<const Environment> plain_environment();

/// Mean cosine between n and the GGX-reflected directions, weighted as in `Environment::reflected`. It is the factor by
/// which filtering flattens a gradient.
double mean_reflected_cosine(double roughness);

/// The environment of the studio (rooms.h), the default light. A shared singleton.
std::shared_ptr<const Environment> studio_environment();

}  // namespace sinew::viewer
