// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace sinew::viewer {

inline constexpr std::uint32_t kMostOcclusionSamples = 64;

/// How much work ambient occlusion is. Shaders are compiled for it, so it is chosen when a renderer is made; what may
/// change from frame to frame is in AmbientOcclusion. The default is the cheapest that looks right: `sinew cost`
/// measures the others.
struct OcclusionShape {
  std::uint32_t samples = 14;    ///< even, 2 to kMostOcclusionSamples
  std::uint32_t step = 2;        ///< pixels from one texel to the next: 2 = half size, 1 = full size
  std::uint32_t blur_reach = 2;  ///< texels to each side, 2 or 4: the noise has a period of 4
  bool keep_edges = true;        ///< the blur stays on one surface

  friend bool operator==(const OcclusionShape&, const OcclusionShape&) = default;
};

}  // namespace sinew::viewer
