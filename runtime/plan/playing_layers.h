// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>

#include "runtime/base/index.h"
#include "runtime/plan/frame_input.h"

namespace sinew {

/// The layers of the later pose; empty if the frame does not use them.
inline std::span<const ClipLayer> next_layers_of(const FrameInput& input) noexcept {
  return input.interpolation_factor == 0.0f ? std::span<const ClipLayer>{} : input.next_layers;
}

/// The lists of the caller that the frame uses. Layers only name masks.
inline PoseProgramInputs inputs_in_use(const FrameInput& input) noexcept {
  return input.program.empty() ? PoseProgramInputs{.masks = input.program_inputs.masks} : input.program_inputs;
}

/// True if at most one clip plays, unmasked, unmirrored and with full weight. Joints that it does not move then have
/// their rest pose to the last bit.
inline bool plays_alone(std::span<const ClipLayer> layers) noexcept {
  std::size_t active = 0;
  for (const ClipLayer& layer : layers)
    if (layer.weight != 0.0f && (++active > 1 || layer.weight < 1.0f || layer.mask != kNone ||
                                 layer.kind != LayerKind::blend || layer.mirrored))
      return false;
  return true;
}

/// The first clip with a weight, or kNone.
inline std::uint32_t playing_clip(std::span<const ClipLayer> layers) noexcept {
  const auto playing =
      std::find_if(layers.begin(), layers.end(), [](const ClipLayer& layer) { return layer.weight != 0.0f; });
  return playing != layers.end() ? playing->clip : kNone;
}

}  // namespace sinew
