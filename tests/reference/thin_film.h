// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec3.hpp>

namespace sinew::reference {

/// A thin film over a surface (KHR_materials_iridescence).
struct ThinFilm {
  double share = 0.0, ior = 1.3, thickness_nm = 0.0;
};

/// Sensitivity of the eye to waves of 1 / `per_metre` metres, in x, y and z. Its integral over all waves is that of
/// the extension's Gaussians, before they are divided by white.
glm::dvec3 eye_sensitivity(double per_metre);

/// Linear sRGB of x, y and z.
glm::dvec3 srgb_from_xyz(const glm::dvec3& xyz);

/// Reflectance of film and surface in linear sRGB, as KHR_materials_iridescence approximates it.
/// eq   R12 + Rs + 2 sum over m = 1, 2 of (Rs - T) sqrt(R12 R23)^m S(m D, m phi), Rs = T^2 R23 / (1 - R12 R23), T = 1 -
///      R12, D = 2 ior thickness cos(angle in the film); R12 and R23 by Schlick; S is the cosine transform of
///      eye_sensitivity()
/// in   f0  reflectance of the surface in air along the normal;   cosine  of the angle of incidence
glm::dvec3 film_reflectance(const ThinFilm& film, const glm::dvec3& f0, double cosine);

/// f0 of Schlick's formula for a reflectance at an angle, 0 to 1.
glm::dvec3 normal_reflectance(const glm::dvec3& reflectance, double cosine);

}  // namespace sinew::reference
