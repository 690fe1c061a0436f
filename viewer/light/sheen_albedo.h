// SPDX-License-Identifier: MIT
#pragma once

namespace sinew::viewer {

/// Directional albedo of white sheen. At grazing angles and low roughness the lobe creates energy and the albedo
/// exceeds 1; the shader divides by the excess.
/// eq   integral over l of D V n.l, with D = (2 + 1/a) sin(h)^(1/a) / 2 pi of Estevez and Kulla, "Production Friendly
///      Microfacet Sheen BRDF" (2017), a = roughness^2, and V = 1 / ((1 + L(n.v) + L(n.l)) 4 n.v n.l) with their fit of
///      L
/// in   n_v  cosine between normal and viewer, [0, 1];   roughness  [0, 1], raised to kLeastSheenRoughness
/// cost 192 evaluations
float sheen_albedo(float n_v, float roughness) noexcept;

inline constexpr float kLeastSheenRoughness =
    5.0f / 63.0f;  ///< a row of the table; below it, the lobe is too narrow for float

}  // namespace sinew::viewer
