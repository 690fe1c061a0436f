// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

#include "viewer/device/device.h"
#include "viewer/passes/frame_graph.h"

namespace sinew::viewer {

/// One pass of a frame, run or left out, with the reason as a sentence: like PlanStage for passes.
struct PassStage {
  Pass pass{};
  bool runs = false;
  std::string_view reason;
  std::uint64_t count = 0;  ///< draws of a pass over meshes, lines of the overlay, pixels of other passes
};

/// Amount of work in a frame.
struct PassWork {
  std::uint32_t caster_draws = 0, opaque_draws = 0, blended_draws = 0, weighted_draws = 0, lines = 0;
  VkExtent2D extent{};          ///< of the picture
  std::uint64_t ao_texels = 0;  ///< of ambient occlusion: those that may have a surface
};

/// All passes in the order in which they run. The frame graph of the same needs contains those that run.
std::array<PassStage, kPassCount> describe_passes(const FrameNeeds& needs, const PassWork& work);

}  // namespace sinew::viewer
