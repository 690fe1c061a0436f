// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

#include "viewer/passes/frame_graph.h"
#include "viewer/upload/texture_filter.h"

namespace sinew::viewer {

/// State of one rendering mode, with the reason as a sentence. The counterpart of PassStage for options.
struct PictureMode {
  std::string_view mode;
  bool runs = false;
  std::string_view reason;
  std::uint64_t count = 0;  ///< multisampling: samples per pixel; anisotropic filter: largest number of samples; else 0
};
inline constexpr std::size_t kModeCount = 5;

/// Describes the modes of a frame: multisampling, texture filter, normal interpolation, tone curve, backdrop.
std::array<PictureMode, kModeCount> describe_modes(const FrameNeeds& needs, const RenderOptions& options,
                                                   const TextureFilter& filter);

}  // namespace sinew::viewer
