// SPDX-License-Identifier: MIT
#pragma once

namespace sinew::viewer {

/// Share of light from all around that white sheen reflects towards the viewer. It is above 1 at grazing angles where
/// roughness is low: the lobe makes energy there, so the shader divides it by what is above 1.
/// eq   integral over l of D V n.l, with D = (2 + 1/a) sin(h)^(1/a) / 2 pi of Estevez and Kulla, "Production Friendly
///      Microfacet Sheen BRDF" (2017), a = roughness^2, and V = 1 / ((1 + L(n.v) + L(n.l)) 4 n.v n.l) with L as they
///      fitted it
/// in   n_v  cosine between normal and viewer, [0, 1];   roughness  [0, 1], at least kLeastSheenRoughness is used
/// cost 192 evaluations
float sheen_albedo(float n_v, float roughness) noexcept;

inline constexpr float kLeastSheenRoughness =
    5.0f / 63.0f;  ///< a row of the table; below, the lobe is thinner than float resolves

}  // namespace sinew::viewer
