// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include <glm/vec3.hpp>

namespace sinew::reference {

/// One of the rays that sample the reflection of a rough mirror.
struct LobeRay {
  glm::dvec3 direction;
  double weight = 0.0;  ///< all weights add up to 1
};

/// Directions of the light that a rough mirror reflects to the viewer. Directions below the surface are left out, so
/// there may be fewer than `count`.
/// eq   half vectors h distributed as D(h) n.h, weighted by V v.h n.l / n.h (as in reflected_once())
/// in   turn  in [0, 1): rotates the pattern, for another set of rays
std::vector<LobeRay> lobe_rays(const glm::dvec3& normal, const glm::dvec3& to_viewer, double roughness, int count,
                               double turn = 0.0);

}  // namespace sinew::reference
