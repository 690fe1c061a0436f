// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/plan/frame_changes.h"

namespace sinew {

/// Stages palette, split_palette and combinations, with the frames since which palettes hold. A palette with the bits
/// of the frame before is neither written nor split nor combined again.
/// in   model[joints of poses];   wanted[skins]  needed by this frame; empty = all that are planned
/// cost O(joints of the skins), no allocation. Internal to plan/
void make_palettes(const CompiledPlan& plan, std::span<const Affine> model, std::span<const bool> wanted,
                   const FrameStep& step, FrameWork& work) noexcept;

/// Numbers of frames since which palettes hold, for a frame whose palettes are in the memory already.
/// cost compares palettes with those of the frame before, where that had another input
void number_kept_palettes(const CompiledPlan& plan, const FrameStep& step) noexcept;

}  // namespace sinew
