// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec3.hpp>

#include "tests/reference/thin_film.h"

namespace sinew::reference {

/// A point of a metallic-roughness surface; directions are unit vectors in one space.
struct ShadedPoint {
  glm::dvec3 base_color{1.0};
  double metallic = 0.0, roughness = 1.0;
  glm::dvec3 normal{0.0, 1.0, 0.0}, to_viewer{0.0, 1.0, 0.0};
  glm::dvec3 dielectric_f0{0.04};   ///< reflectance of the dielectric along its normal
  double dielectric_f90 = 1.0;      ///< its reflectance at grazing angles
  double transmission = 0.0;        ///< share of the light that enters the dielectric and passes through
  ThinFilm film;                    ///< KHR_materials_iridescence
  glm::dvec3 along{1.0, 0.0, 0.0};  ///< direction of a stretched highlight, perpendicular to the normal
  double anisotropy = 0.0;          ///< 0 to 1
};

/// A clear layer over a surface (KHR_materials_clearcoat).
struct Coat {
  double weight = 0.0, roughness = 0.0;
  glm::dvec3 normal{0.0, 1.0, 0.0};
};

/// Share of the light that the layer reflects; the surface below does not get it.
/// eq   KHR_materials_clearcoat: weight * (0.04 + 0.96 * (1 - |n.v|)^5)
double coat_share(const Coat& coat, const glm::dvec3& to_viewer);

/// D V n.l of GGX with height-correlated Smith visibility; 0 if the light is behind the surface.
double ggx(const glm::dvec3& normal, const glm::dvec3& to_viewer, const glm::dvec3& to_light, double roughness);

/// D V n.l of a surface with a stretched highlight.   (KHR_materials_anisotropy)
/// eq   D = 1 / (pi a b ((t.h / a)^2 + (b.h / b)^2 + n.h^2)^2), V = 1 / (2 (n.l |(a t.v, b b.v, n.v)| + n.v |(a t.l, b
///      b.l, n.l)|)), with b = roughness^2 across the direction, and a = b + (1 - b) anisotropy^2 along it
double stretched_ggx(const ShadedPoint& point, const glm::dvec3& to_light);

/// Radiance towards the viewer from light of one direction.
/// eq   glTF 2.0, Appendix B.3: mix(dielectric, metal, metallic) with GGX and height-correlated Smith visibility;
///      KHR_materials_transmission: diffuse * (1 - transmission)
///      KHR_materials_iridescence: film_reflectance() in place of F, as far as the film reaches
///      KHR_materials_specular: dielectric = diffuse * (1 - max(F)) + specular * F, F = f0 + (f90 - f0) * (1 - v.h)^5
glm::dvec3 direct(const ShadedPoint& point, const glm::dvec3& to_light, const glm::dvec3& irradiance);

/// Khronos PBR Neutral tone mapping.
glm::dvec3 tone_mapped(const glm::dvec3& color);

/// eq   ACES as fitted by Hill (2016): M2 f(M1 color / 0.6) with f(v) = (v (v + 0.0245786) - 0.000090537) /
///      (v (0.983729 v + 0.432951) + 0.238081), clipped to [0, 1]
glm::dvec3 tone_mapped_aces(const glm::dvec3& color);

/// IEC 61966-2-1, per component.
double srgb_encoded(double linear);
double srgb_decoded(double encoded);

}  // namespace sinew::reference
