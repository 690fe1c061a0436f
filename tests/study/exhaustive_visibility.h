// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "tests/study/seen_pixels.h"

namespace sinew::viewer {

/// Ambient visibility of every pixel by horizons, like shaders/gtao.frag, but in double precision. It reads every pixel
/// within the radius, in 32 directions. The difference to the pass is its sampling error; the difference to ray casting
/// is the error of screen space itself. 1 where nothing is visible.
/// in   view       of the pixels, perspective
///      thickness  assumed thickness of bodies behind visible surfaces, in radii
/// cost O(pixels * radius in pixels)
std::vector<double> exhaustive_visibility(const SeenPixels& seen, const View& view, double radius_m, double thickness);

}  // namespace sinew::viewer
