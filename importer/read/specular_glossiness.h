// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/conventions.h"

namespace sinew {

/// Factors of KHR_materials_pbrSpecularGlossiness; colours are linear.
struct SpecularGlossiness {
  glm::dvec3 diffuse{1.0}, specular{1.0};
  double glossiness = 1.0;
};

struct MetallicRoughness {
  glm::dvec3 base_color{1.0};
  double metallic = 1.0, roughness = 1.0;
};

/// Approximates a specular-glossiness surface by a metallic-roughness surface. Exact if the specular colour is 0.04
/// (dielectric) or the diffuse colour is black. In between, `metallic` is chosen to preserve the brightness of both
/// lobes.
/// eq   m in [0, 1] solves  0.04 m^2 + (d (1 - s) / 0.96 + p - 0.08) m + 0.04 - p = 0,  d and p the perceived
///      brightness of the diffuse and the specular colour, s the largest component of the specular colour; roughness =
///      1 - glossiness.   Derived from  diffuse (1 - s) = base (1 - 0.04)(1 - m),  specular = lerp(0.04, base, m)
MetallicRoughness to_metallic_roughness(const SpecularGlossiness& surface) noexcept;

}  // namespace sinew
