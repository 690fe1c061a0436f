// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include <glm/vec3.hpp>

namespace sinew::reference {

/// How much of the ambient light other surfaces let through.
struct Openness {
  double visibility = 1.0;  ///< share of the light that arrives, weighted by the cosine to the normal
  /// Unit mean direction of the arriving light minus the normal. Without it `visibility` scales reflections.
  std::optional<glm::dvec3> bend;
  double baked = 1.0;  ///< share of all ambient light that an occlusion texture leaves; multiplies `visibility`
};

/// Approximate area that two circles on the unit sphere share, divided by 2 pi.
/// eq   smoothstep of the part of the smaller circle's width that lies in the other, times the smaller area
///      (Oat and Sander, "Ambient Aperture Lighting" (2007))
/// in   cosines of the two radii, and of the angle between the centers
double overlap(double cos_a, double cos_b, double cos_between);

/// Share of the light around the mirror direction that other surfaces let through.
/// eq   baked * mix(overlap(visible, lobe) / overlap(half sphere, lobe), visibility, roughness^2), where `visible` is a
///      circle about the bent normal b, the half sphere is about the normal n, and the lobe is about the mirror
///      direction; cos^2 of visible = 1 - visibility / b.n, at least 0; cos of lobe = 10^(-roughness^2 - 0.1)
double mirrored_visibility(const Openness& open, const glm::dvec3& normal, const glm::dvec3& to_viewer,
                           double roughness);

/// Light that surfaces which hide the mirror direction reflect, as a share of the half sphere's light. They are taken
/// to have the colour of this surface and to be lit as it is.
/// eq   visibility * (baked - mirrored_visibility) * color
glm::dvec3 mirrored_surroundings(const Openness& open, double mirrored, const glm::dvec3& color);

}  // namespace sinew::reference
