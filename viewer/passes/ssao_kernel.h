// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "viewer/passes/occlusion_shape.h"

namespace sinew::viewer {

/// Sample offsets of ambient occlusion, in opposite pairs. Up to 14 samples: the 8 corners of a cube, then its 6 face
/// centers. More: a spherical Fibonacci lattice. Lengths are random in [0.25, 1].
using SsaoOffsets = std::vector<glm::vec3>;

/// Unit vectors for a tile of 4 x 4 pixels; the offsets of a pixel are reflected about its vector.
using SsaoNoise = std::array<glm::vec3, 16>;

struct SsaoKernel {
  SsaoOffsets offsets;
  SsaoNoise noise;
};

/// Deterministic: the same numbers on every machine.
/// in   samples  OcclusionShape::samples
SsaoKernel make_ssao_kernel(std::uint32_t samples = OcclusionShape{}.samples);

}  // namespace sinew::viewer
