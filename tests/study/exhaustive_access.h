// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "tests/study/seen_pixels.h"

namespace sinew::viewer {

/// Ambient access of every pixel by horizons, as shaders/gtao.frag finds them, but with every pixel within the radius
/// looked at, in 32 directions, in double precision. It shows how much of the error of the pass is haste, and how much
/// is that a picture does not show what is hidden or turned away. 1 where nothing is visible.
/// in   view       of the pixels, a perspective
///      thickness  in radii: bodies are that thick behind what is seen, and hide light where they reach into the radius
/// cost O(pixels * radius in pixels)
std::vector<double> exhaustive_access(const SeenPixels& seen, const View& view, double radius_m, double thickness);

}  // namespace sinew::viewer
