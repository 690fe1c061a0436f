// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "viewer/upload/mip_chain.h"

namespace sinew::viewer {

/// Scales the alpha of a mip level so that an alpha test keeps the same coverage as at level 0. Plain averaging would
/// make leaves and wires vanish in the distance.
/// eq   Castano, "Computing Alpha Mipmaps" (2010): alpha * s, with s chosen so that the share of sample points at or
///      above the cutoff is closest to that of level 0; of equal s, the nearest to 1. Sample points: four per texel, a
///      quarter texel from its center, bilinearly interpolated
/// in   cutoff  least alpha that passes the test, at least 1
/// cost O(texels of both levels)
void keep_coverage(const MipLevel& image, std::uint8_t cutoff, MipLevel& level);

}  // namespace sinew::viewer
