// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include <glm/vec3.hpp>

namespace sinew::reference {

/// One of the rays that sample the reflection of a rough mirror.
struct LobeRay {
  glm::dvec3 direction;
  double weight = 0.0;  ///< the weights of all sum up to 1
};

/// Rays from which a rough mirror reflects light towards the viewer; fewer than `count` where some would go below it.
/// eq   half vectors h distributed as D(h) n.h, weighted by V v.h n.l / n.h (as reflected_once())
/// in   turn  in [0, 1): other rays of the same kind
std::vector<LobeRay> lobe_rays(const glm::dvec3& normal, const glm::dvec3& to_viewer, double roughness, int count,
                               double turn = 0.0);

}  // namespace sinew::reference
