// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "viewer/passes/view.h"
#include "tests/study/ray_caster.h"

namespace sinew::viewer {

/// What a picture shows: the surface that rays through the middles of its pixels meet, the top row first.
struct SeenPixels {
  std::uint32_t width = 0, height = 0;
  std::vector<std::optional<RayCaster::Seen>> pixels;
};

/// in   view  a perspective
SeenPixels seen_pixels(const RayCaster& rays, const View& view, std::uint32_t width, std::uint32_t height);

}  // namespace sinew::viewer
