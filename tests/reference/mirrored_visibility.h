// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include <glm/vec3.hpp>

namespace sinew::reference {

/// What other surfaces leave of ambient light.
struct Openness {
  double visibility = 1.0;         ///< share that arrives, weighted by the cosine to the normal
  std::optional<glm::dvec3> bend;  ///< from the normal to the unit mean direction of what arrives; reflections without
                                   ///< it are scaled by `visibility`
  double baked = 1.0;              ///< share that a texture leaves of all ambient light, besides
};

/// Area that two circles on the unit sphere share, of 2 pi, about.
/// eq   smoothstep of the part of the smaller circle's width that lies in the other, times the smaller area
///      (Oat and Sander, "Ambient Aperture Lighting" (2007))
/// in   cosines of the radii, and of the angle between the middles
double overlap(double cos_a, double cos_b, double cos_between);

/// Share of the light around the mirror direction that other surfaces let through.
/// eq   baked times: overlap(visible, lobe) about the bent normal b over overlap(half sphere, lobe) about the normal n, mixed with visibility
///      by roughness^2; cos^2 of visible = 1 - visibility / b.n, at least 0; cos of lobe = 10^(-roughness^2 - 0.1)
double mirrored_visibility(const Openness& open, const glm::dvec3& normal, const glm::dvec3& to_viewer,
                           double roughness);

/// Light that is reflected where other surfaces hide the mirror direction, as a share of that of the half sphere: they
/// have the colour of the surface and get as much light.
/// eq   visibility * (baked - mirrored_visibility) * color
glm::dvec3 mirrored_surroundings(const Openness& open, double mirrored, const glm::dvec3& color);

}  // namespace sinew::reference
