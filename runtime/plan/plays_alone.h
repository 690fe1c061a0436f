// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>

#include "runtime/plan/frame_input.h"

namespace sinew {

/// At most one clip plays, and alone makes up the pose: where it moves no joints they have their rest pose to the last
/// bit.
inline bool plays_alone(std::span<const ClipLayer> layers) noexcept {
  std::size_t active = 0;
  for (const ClipLayer& layer : layers)
    if (layer.weight != 0.0f &&
        (++active > 1 || layer.weight < 1.0f || layer.mask != kNone || layer.kind != LayerKind::blend))
      return false;
  return true;
}

}  // namespace sinew
