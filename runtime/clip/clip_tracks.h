// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace sinew {

/// Tracks that one sample of a clip evaluates.
struct ClipTracks {
  std::uint32_t joints = 0, weights = 0, properties = 0;
  bool moves_joints = false;  ///< by such tracks, or by constants other than the rest pose
};

}  // namespace sinew
