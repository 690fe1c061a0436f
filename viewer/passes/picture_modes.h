// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

#include "viewer/passes/frame_graph.h"
#include "viewer/upload/texture_filter.h"

namespace sinew::viewer {

/// A choice of how passes make a picture, in effect or not, with the reason as a sentence: like PassStage for choices.
struct PictureMode {
  std::string_view mode;
  bool runs = false;
  std::string_view reason;
  std::uint64_t count = 0;  ///< samples a pixel; most places of an anisotropic filter; else 0
};
inline constexpr std::size_t kModeCount = 5;

/// Samples a pixel, texture filter, normals between vertices, tone curve and backdrop of a frame of these needs.
std::array<PictureMode, kModeCount> describe_modes(const FrameNeeds& needs, const RenderOptions& options,
                                                   const TextureFilter& filter);

}  // namespace sinew::viewer
