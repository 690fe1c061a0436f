// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "tests/study/ray_caster.h"
#include "viewer/passes/view.h"

namespace sinew::viewer {

/// The visible surface at each pixel center, top row first.
struct SeenPixels {
  std::uint32_t width = 0, height = 0;
  std::vector<std::optional<RayCaster::Seen>> pixels;
};

/// in   view  a perspective
SeenPixels seen_pixels(const RayCaster& rays, const View& view, std::uint32_t width, std::uint32_t height);

}  // namespace sinew::viewer
