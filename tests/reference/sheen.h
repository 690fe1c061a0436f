// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec3.hpp>

namespace sinew::reference {

/// Fibres on a surface (KHR_materials_sheen).
struct SheenLayer {
  glm::dvec3 color{0.0};
  double roughness = 0.0;
};

/// Fibre distribution D times visibility V.
/// eq   Estevez and Kulla, "Production Friendly Microfacet Sheen BRDF" (2017), with their fit of Lambda and
///      alpha = roughness^2
double sheen_lobe(double n_v, double n_l, double n_h, double roughness);

/// Share of light from all around that white sheen reflects: the integral of D V n.l over the half sphere, by the
/// midpoint rule.
double sheen_albedo(double n_v, double roughness);

/// Light that the layer adds, and the share it leaves to the surface below.
/// eq   KHR_materials_sheen: added = color D V n.l, divided by E(n.v) where that is above 1;
///      left = 1 - max(color) min(1, max(E(n.v), E(n.l))), with E = sheen_albedo()
struct SheenShare {
  glm::dvec3 added{0.0};
  double left = 1.0;
};
SheenShare sheen_of_light(const SheenLayer& sheen, const glm::dvec3& normal, const glm::dvec3& to_viewer,
                          const glm::dvec3& to_light);

/// Same for ambient light: color E(n.v) of the light of the half sphere, with E limited to 1.
SheenShare sheen_of_ambient(const SheenLayer& sheen, const glm::dvec3& normal, const glm::dvec3& to_viewer);

}  // namespace sinew::reference
