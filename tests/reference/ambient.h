// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec2.hpp>

#include "tests/reference/mirrored_visibility.h"
#include "tests/reference/shade.h"

namespace sinew::reference {

/// Share of uniform light from all directions that one reflection returns: f0 * x + y, with (x, y) the result.
/// eq   integral over half vectors h, distributed as D(h) n.h, of 4 V v.h n.l / n.h, with (1 - v.h)^5 in y and the
///      rest of Schlick's term in x; by the midpoint rule over the angle to the normal and the turn about it
glm::dvec2 reflected_once(double n_v, double roughness);

/// Mean cosine between the normal and the light that a rough mirror reflects to a viewer who looks along the normal.
/// eq   integral of n.l^2 D over the integral of n.l D
double reflected_cosine(double roughness);

/// Ambient light that changes evenly from `ground` below to `sky` above.
struct AmbientGradient {
  glm::dvec3 up{0.0, 1.0, 0.0}, sky{0.0}, ground{0.0};
};

/// Radiance towards the viewer from ambient light.
/// eq   A layer of reflectance f0 and f90 returns once = f0 x + f90 y of the light, with (x, y) = reflected_once().
///      Light that goes on between its facets adds again = once m rest / (1 - m rest), with rest = 1 - x - y and the
///      mean reflectance m = f0 + (f90 - f0) / 21.
///      A metal is such a layer: f0 = base colour, f90 = 1. A dielectric is a layer of its own f0 and f90 over a matte
///      ground, which gets the share 1 - max(once + again), less the transmission.
///      `once` sees the light around the mirror direction, times mirrored_visibility(), plus the light of the half
///      sphere, times mirrored_surroundings() of the base colour. `again` and the ground see the light of the half
///      sphere, times scattered_visibility() of visibility * baked and the base colour (black for metals).
glm::dvec3 ambient(const ShadedPoint& point, const AmbientGradient& light, const Openness& open = {});

/// Share of the light behind a thin surface that passes through.
/// eq   KHR_materials_transmission: base colour * (1 - max(once + again)) * (1 - metallic) * transmission, with the
///      dielectric's once and again of ambient()
glm::dvec3 passed_through(const ShadedPoint& point);

/// Light around a direction, averaged over the cone that a surface of this roughness reflects.
glm::dvec3 light_around(const AmbientGradient& light, const glm::dvec3& direction, double roughness);

/// Mean light of the half sphere about a normal, weighted with the cosine.
glm::dvec3 diffuse_light(const AmbientGradient& light, const glm::dvec3& normal);

/// Radiance towards the viewer from a clear coat in ambient light, before its weight is applied.
/// eq   (light of the mirror direction * once + that of the half sphere * (1 - once)) * mirrored_visibility()
///      + light of the half sphere * mirrored_surroundings() of `below`, with once = x + y of reflected_once()
/// in   below  base colour of the surface under the coat
glm::dvec3 ambient(const Coat& coat, const glm::dvec3& below, const glm::dvec3& to_viewer, const AmbientGradient& light,
                   const Openness& open = {});

}  // namespace sinew::reference
