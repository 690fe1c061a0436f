// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include <glm/vec3.hpp>

namespace sinew::viewer {

/// Directions of the ambient-occlusion samples: the 8 corners of a cube, then the 6 centres of its faces, opposite ones
/// next to each other, so that any first part of the list is spread evenly. Lengths are random in [0.25, 1].
using SsaoOffsets = std::array<glm::vec3, 14>;

/// Unit vectors that the offsets of a pixel are reflected by, one per pixel of a tile of 4 x 4.
using SsaoNoise = std::array<glm::vec3, 16>;

struct SsaoKernel {
  SsaoOffsets offsets;
  SsaoNoise noise;
};

/// The same numbers in every run and on every machine.
SsaoKernel make_ssao_kernel();

}  // namespace sinew::viewer
