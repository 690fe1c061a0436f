// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace sinew {

/// Tracks that one sample of a clip evaluates.
struct ClipTracks {
  std::uint32_t joints = 0, weights = 0, properties = 0;
  bool moves_joints = false;  ///< tracks move joints, or constant tracks hold them elsewhere than at rest
};

}  // namespace sinew
