// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include <glm/vec3.hpp>

namespace sinew::reference {

/// Gooch's cool to warm tone of a surface, in sRGB values.
/// eq   Gooch et al. (1998), eqs. 2 to 4: (1 - t) (blue + 0.2 base) + t (yellow + 0.6 base), t = (1 + n.l) / 2,
///      blue = (0, 0, 0.4), yellow = (0.4, 0.4, 0); white over it by clamp(100 r.v - 97), r = l mirrored about n
/// in   base  sRGB;   n, to_light, to_viewer  unit
glm::dvec3 gooch_tone(const glm::dvec3& base, const glm::dvec3& n, const glm::dvec3& to_light,
                      const glm::dvec3& to_viewer);

/// A pixel of the normal and depth pass.
struct OutlinePixel {
  double distance_m = 0.0;  ///< 0 = nothing was drawn
  glm::dvec3 normal{0.0};   ///< unit; zero = surface without normal
};

/// Darkness of the outline at the middle one of three neighbouring pixels. The middle pixel must have a normal.
/// eq   silhouette = smoothstep(4, 8, distance in pixels by which the outer two lie behind the middle, added up). The
///      distance of a plane is harmonic along a row of a perspective picture and linear in a parallel one.
///      crease = 1 - smoothstep(0.7, 0.87, least cosine between the middle normal and an outer one)
double outline(const std::array<OutlinePixel, 3>& row, double pixels_per_metre, bool parallel);

}  // namespace sinew::reference
