// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "viewer/upload/mip_chain.h"

namespace sinew::viewer {

/// Scales the alpha of a smaller level of an image, so that an alpha test keeps the same share of it as of the whole
/// image. Means of alpha alone lose leaves and wires in the distance: what covers less than half is cut everywhere.
/// eq   Castano, "Computing Alpha Mipmaps" (2010): alpha * s, with the s for which as near as possible to the same share
///      of points is at least the cutoff; of all such s the one nearest to 1. Points are four a texel, a quarter of a
///      texel from its middle, interpolated as samplers do
/// in   cutoff  least alpha that the test keeps, at least 1
/// cost O(texels of both)
void keep_coverage(const MipLevel& image, std::uint8_t cutoff, MipLevel& level);

}  // namespace sinew::viewer
