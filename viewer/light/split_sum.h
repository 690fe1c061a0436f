// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace sinew::viewer {

/// Share of light from all around that a GGX surface reflects once: f0 * x + y, for the reflectance f0 along the
/// normal.
/// eq   Karis, "Real Shading in Unreal Engine 4" (2013): integral over l of D F V 4 n.l / 4 with Schlick's F taken apart,
///      (1 - (1 - v.h)^5) in x and (1 - v.h)^5 in y; height-correlated Smith V. Half vectors are distributed as the
///      viewer sees them: Heitz, "Sampling the GGX Distribution of Visible Normals" (2018)
/// in   n_v  cosine between normal and viewer, [0, 1];   roughness [0, 1]
/// cost 512 evaluations
glm::vec2 split_sum(float n_v, float roughness) noexcept;

inline constexpr std::uint32_t kSplitSumSize = 64;

/// [kSplitSumSize^2] split_sum in x and y, sheen_albedo in z. Rows of equal roughness, from 0 to 1; along a row
/// sqrt(n_v) from 0 to 1, because the sums change fastest at grazing angles. Both ends are on the middles of the outer
/// texels. Computed once in a process.
const std::vector<glm::vec3>& split_sum_table();

}  // namespace sinew::viewer
