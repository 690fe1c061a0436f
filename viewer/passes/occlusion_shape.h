// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace sinew::viewer {

inline constexpr std::uint32_t kMostOcclusionSamples = 64;

/// Quality settings of ambient occlusion. Shaders are compiled for them, so they are fixed for a renderer's life;
/// AmbientOcclusion holds the per-frame settings. The defaults are the cheapest that look right; `sinew cost` measures
/// alternatives.
struct OcclusionShape {
  std::uint32_t samples = 14;    ///< samples of ssao; even, 2 to kMostOcclusionSamples
  std::uint32_t slices = 2;      ///< gtao: number of slices
  std::uint32_t steps = 6;       ///< gtao: depth reads on either side of a slice
  std::uint32_t step = 2;        ///< pixels per texel along each axis: 2 = half size, 1 = full size
  std::uint32_t blur_reach = 2;  ///< texels to each side: 2 or 4, because the noise repeats every 4 texels
  bool keep_edges = true;        ///< the blur does not mix different surfaces

  friend bool operator==(const OcclusionShape&, const OcclusionShape&) = default;
};

}  // namespace sinew::viewer
