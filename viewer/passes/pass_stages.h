// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

#include "viewer/device/device.h"
#include "viewer/passes/frame_graph.h"

namespace sinew::viewer {

/// State of one pass in a frame: run or skipped, with the reason as a sentence. The counterpart of PlanStage.
struct PassStage {
  Pass pass{};
  bool runs = false;
  std::string_view reason;
  std::uint64_t count = 0;  ///< mesh passes: draws; overlay: lines; other passes: pixels
};

/// Amount of work in a frame.
struct PassWork {
  std::uint32_t caster_draws = 0, opaque_draws = 0, blended_draws = 0, weighted_draws = 0, lines = 0;
  VkExtent2D extent{};                                 ///< of the picture
  std::uint64_t ao_texels = 0;                         ///< texels of ambient occlusion that may show a surface
  std::uint64_t drawn_pixels = 0, outline_pixels = 0;  ///< pixels in which the scene, and its outlines, may be
};

/// Describes all passes in order, also those that do not run. Consistent with FrameGraph(needs).
std::array<PassStage, kPassCount> describe_passes(const FrameNeeds& needs, const PassWork& work);

}  // namespace sinew::viewer
