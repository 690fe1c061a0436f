// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "viewer/passes/occlusion_shape.h"

namespace sinew::viewer {

/// Directions of the ambient-occlusion samples, opposite ones next to each other, so that any first part of the list is
/// spread evenly. Up to 14: the 8 corners of a cube, then the 6 centres of its faces; more: points of a spherical
/// Fibonacci lattice. Lengths are random in [0.25, 1].
using SsaoOffsets = std::vector<glm::vec3>;

/// Unit vectors that the offsets of a pixel are reflected by, one per pixel of a tile of 4 x 4.
using SsaoNoise = std::array<glm::vec3, 16>;

struct SsaoKernel {
  SsaoOffsets offsets;
  SsaoNoise noise;
};

/// The same numbers in every run and on every machine.
/// in   samples  even, OcclusionShape::samples
SsaoKernel make_ssao_kernel(std::uint32_t samples = OcclusionShape{}.samples);

}  // namespace sinew::viewer
