// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec2.hpp>

#include "tests/reference/mirrored_visibility.h"
#include "tests/reference/shade.h"

namespace sinew::reference {

/// Share of light from all around that is reflected once: f0 * x + y.
/// eq   integral over half vectors h, distributed as D(h) n.h, of 4 V v.h n.l / n.h, with (1 - v.h)^5 in y and the
///      rest of Schlick's term in x; by the midpoint rule over the angle to the normal and the turn about it
glm::dvec2 reflected_once(double n_v, double roughness);

/// Mean cosine between a normal and the light that a rough mirror reflects, seen along its normal.
/// eq   integral of n.l^2 D over the integral of n.l D
double reflected_cosine(double roughness);

/// Ambient light that changes evenly from `ground` below to `sky` above.
struct AmbientGradient {
  glm::dvec3 up{0.0, 1.0, 0.0}, sky{0.0}, ground{0.0};
};

/// Radiance towards the viewer from ambient light.
/// eq   a layer of reflectance f0 returns once = f0 x + f90 y, and of the rest 1 - x - y, with the mean reflectance
///      m = f0 + (f90 - f0) / 21, again = once m rest / (1 - m rest); the metal is such a layer of its base colour and
///      f90 = 1, the dielectric one of its own over a matte ground, which gets 1 - max(once + again), without the
///      transmission.
///      The light of `once` is that around the mirror direction, times mirrored_visibility(), and that of the half
///      sphere, times mirrored_surroundings() of the base colour; of the others that of the half sphere, times
///      scattered_visibility() of visibility * baked and the base colour, which is black for metals
glm::dvec3 ambient(const ShadedPoint& point, const AmbientGradient& light, const Openness& open = {});

/// Share of the light behind a thin surface that passes through.
/// eq   KHR_materials_transmission: transmission of what the dielectric's layer leaves, 1 - max(once + again), in the
///      base colour
glm::dvec3 passed_through(const ShadedPoint& point);

/// Light around a direction, as far around it as a surface is rough.
glm::dvec3 light_around(const AmbientGradient& light, const glm::dvec3& direction, double roughness);

/// Mean light of the half sphere about a normal, weighted with the cosine.
glm::dvec3 diffuse_light(const AmbientGradient& light, const glm::dvec3& normal);

/// The same from a clear layer, before its share: such a layer of f0 = f90 = 1, all of whose light has
/// mirrored_visibility().
/// in   below  base colour of what is below
glm::dvec3 ambient(const Coat& coat, const glm::dvec3& below, const glm::dvec3& to_viewer, const AmbientGradient& light,
                   const Openness& open = {});

}  // namespace sinew::reference
