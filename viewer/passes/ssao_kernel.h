// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "viewer/passes/occlusion_shape.h"

namespace sinew::viewer {

/// Offsets of the ambient occlusion samples. Opposite directions are neighbours in the list, so that the first n are
/// spread evenly for every even n. Up to 14 samples: the 8 corners of a cube, then the 6 centres of its faces. More: a
/// spherical Fibonacci lattice. Lengths are random in [0.25, 1].
using SsaoOffsets = std::vector<glm::vec3>;

/// Unit vectors, one per pixel of a tile of 4 x 4: the offsets of the pixel are reflected about it.
using SsaoNoise = std::array<glm::vec3, 16>;

struct SsaoKernel {
  SsaoOffsets offsets;
  SsaoNoise noise;
};

/// Returns the same numbers in every run and on every machine.
/// in   samples  even, OcclusionShape::samples
SsaoKernel make_ssao_kernel(std::uint32_t samples = OcclusionShape{}.samples);

}  // namespace sinew::viewer
