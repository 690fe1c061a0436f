// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

#include "viewer/device/device.h"
#include "viewer/passes/frame_graph.h"

namespace sinew::viewer {

/// One pass of a frame, run or left out, with the reason in words a person understands: PlanStage's counterpart.
struct PassStage {
  Pass pass{};
  bool runs = false;
  std::string_view reason;
  std::uint64_t count = 0;  ///< draws of a pass over meshes, lines of the overlay, pixels of the others
};

/// What a frame has to draw.
struct PassWork {
  std::uint32_t opaque_draws = 0, blended_draws = 0, lines = 0;
  VkExtent2D extent{}, access_extent{};  ///< of the picture, and of the ambient-access image
};

/// All passes that exist, in the order in which they run. Those that run are the frame graph's of the same needs.
std::array<PassStage, kPassCount> describe_passes(const FrameNeeds& needs, const PassWork& work);

}  // namespace sinew::viewer
