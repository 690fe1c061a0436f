// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "tests/reference/ambient.h"
#include "tests/reference/light.h"
#include "tests/reference/surface_point.h"

namespace sinew::reference {

/// The light that reaches a surface point.
struct Surroundings {
  std::span<const ArrivingLight> lights;  ///< light that arrives at the point
  AmbientGradient ambient;
  Openness open;
};

/// Base colour and alpha: factor * texture * vertex colour.   (glTF 2.0, 3.9.2)
glm::dvec4 base_color(const Scene& scene, const SurfacePoint& point);

/// The normal on the seen side: that of the vertices, reversed on back sides.   (glTF 2.0, 3.9.6)
glm::dvec3 seen_normal(const SurfacePoint& point);

/// The normal for lighting and occlusion: from the normal map where there is one, else seen_normal().
glm::dvec3 mapped_normal(const Scene& scene, const SurfacePoint& point);

/// Linear light from a surface point to the viewer.
/// eq   glTF 2.0, 3.9 and appendix B: metallic = factor * blue, roughness = factor * green (at least 0.045);
///      normal map (2 texel - 1) * (scale, scale, 1), the whole normal reversed on back sides;
///      ambient light * (1 + strength * (red - 1)); emission = factor * KHR_materials_emissive_strength * texture.
///      KHR_materials_sheen (sheen.h) between it and the coat.
///      KHR_materials_clearcoat: share * coat + (1 - share) * all of this.
///      KHR_materials_unlit: the base colour alone. Where there is no normal: base colour + emission.
///      KHR_materials_transmission: the light that passes through is subtracted from the diffuse term.
glm::dvec3 radiance(const Scene& scene, const SurfacePoint& point, const Surroundings& around);

/// True if light passes through the surface of this material (KHR_materials_transmission).
bool transmits(const SurfacePoint& point);

/// Roughness of the material times its texture, 0 to 1.
double roughness_at(const Scene& scene, const SurfacePoint& point);

/// Length of the way of light through the volume: thickness * green of its texture * scale of the mesh.
double path_in_volume(const Scene& scene, const SurfacePoint& point);

/// Where the viewer's ray leaves the volume.   (Snell's law)
glm::dvec3 exit_of(const Scene& scene, const SurfacePoint& point);

/// Share of the light behind the surface that reaches the viewer, after the losses in sheen, coat and volume.
/// eq   KHR_materials_volume: attenuation color^(path / attenuation distance)
glm::dvec3 transmitted(const Scene& scene, const SurfacePoint& point);

}  // namespace sinew::reference
