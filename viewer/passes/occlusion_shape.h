// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace sinew::viewer {

inline constexpr std::uint32_t kMostOcclusionSamples = 64;

/// How much work ambient occlusion does. Shaders are compiled for these values, so they are fixed when a renderer is
/// made; AmbientOcclusion has those that may change from frame to frame. The defaults are the cheapest that look right;
/// `sinew cost` measures the others.
struct OcclusionShape {
  std::uint32_t samples = 14;    ///< of ssao, even, 2 to kMostOcclusionSamples
  std::uint32_t slices = 2;      ///< of gtao
  std::uint32_t steps = 6;       ///< on either side of a slice
  std::uint32_t step = 2;        ///< pixels per texel and axis: 2 = half size, 1 = full size
  std::uint32_t blur_reach = 2;  ///< texels to each side, 2 or 4, because the noise has a period of 4
  bool keep_edges = true;        ///< the blur does not mix different surfaces

  friend bool operator==(const OcclusionShape&, const OcclusionShape&) = default;
};

}  // namespace sinew::viewer
