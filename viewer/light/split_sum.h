// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace sinew::viewer {

/// Scale and bias of the split-sum approximation. The single-scattering directional albedo of GGX is f0 * x + y, with
/// reflectance f0 at normal incidence.
/// eq   Karis, "Real Shading in Unreal Engine 4" (2013): integral over l of D F V 4 n.l / 4 with Schlick's F split into
///      (1 - (1 - v.h)^5) for x and (1 - v.h)^5 for y; height-correlated Smith V. Half vectors are sampled from the
///      visible normals: Heitz, "Sampling the GGX Distribution of Visible Normals" (2018)
/// in   n_v  cosine between normal and viewer, [0, 1];   roughness [0, 1]
/// cost 512 evaluations
glm::vec2 split_sum(float n_v, float roughness) noexcept;

inline constexpr std::uint32_t kSplitSumSize = 64;

/// [kSplitSumSize^2] split_sum in x and y, sheen_albedo in z. Rows: roughness from 0 to 1. Columns: sqrt(n_v) from 0 to
/// 1, because values change fastest at grazing angles. Both ends lie on the centers of the outer texels. Computed once
/// per process.
const std::vector<glm::vec3>& split_sum_table();

}  // namespace sinew::viewer
