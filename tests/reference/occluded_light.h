// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec3.hpp>

namespace sinew::reference {

/// Share of the ambient light that a matte surface gets, including the light that nearby surfaces of its colour
/// scatter.
/// eq   max(visibility, ((a visibility + b) visibility + c) visibility), at most 1; a = 2.0404 albedo - 0.3324,
///      b = 0.6417 - 4.7951 albedo, c = 2.7552 albedo + 0.6903   (Jimenez, Wu, Pesce and Jarabo, "Practical Realtime
///      Strategies for Accurate Indirect Occlusion" (2016), section 5)
/// in   visibility  share of the light that arrives without being scattered
glm::dvec3 scattered_visibility(double visibility, const glm::dvec3& albedo);

}  // namespace sinew::reference
