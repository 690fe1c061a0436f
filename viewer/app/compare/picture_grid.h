// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>

#include "viewer/app/headless.h"

namespace sinew::viewer {

/// Pictures of one size in rows of `columns`, from the top left, with a gap of kGridGap pixels between them. Gaps and
/// missing pictures of the last row are transparent.
Picture picture_grid(std::span<const Picture> pictures, std::size_t columns);
inline constexpr std::uint32_t kGridGap = 2;

/// A vertical bar of the colours of distances in the middle of a dark picture: 0 below, the full distance above.
Picture distance_scale(std::uint32_t width, std::uint32_t height);

}  // namespace sinew::viewer
