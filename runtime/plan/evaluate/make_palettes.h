// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/plan/evaluate/frame_step.h"

namespace sinew {

/// Runs the stages palette, split_palette and combinations. A palette is kept if its model matrices have not changed. A
/// new palette with the bits that the memory already holds is neither split nor combined again.
/// in   model[joints of poses];   wanted[skins]  needed by this frame; empty = all that are planned
/// cost O(joints of the skins), no allocation. Internal to plan/
void make_palettes(const CompiledPlan& plan, std::span<const Affine> model, std::span<const bool> wanted,
                   const FrameStep& step, FrameWork& work) noexcept;

}  // namespace sinew
