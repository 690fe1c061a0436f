// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "tests/study/seen_pixels.h"

namespace sinew::viewer {

/// Ambient access of every pixel by horizons in 32 directions, in double precision; 1 where nothing is visible.
/// shaders/gtao.frag samples some pixels within the radius, this looks at all of them. The difference is the error of
/// sampling; the rest of the error of the pass is surfaces that a picture does not show.
/// in   view       of the pixels, a perspective
///      thickness  in radii: bodies are that thick behind what is seen, and hide light where they reach into the radius
/// cost O(pixels * radius in pixels)
std::vector<double> exhaustive_access(const SeenPixels& seen, const View& view, double radius_m, double thickness);

}  // namespace sinew::viewer
