// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/plan/frame_tables.h"

namespace sinew {

/// A frame in the making, beside the one before it of the same character. Both may be in the same memory.
struct FrameStep {
  FrameMemory memory;
  FrameTables tables;
  FrameMemory memory_before;
  FrameTables tables_before;
  std::uint64_t number = 0;
  StandingJoints standing = StandingJoints::none;
  bool is_mean = false;     // of several layers, or between two updates
  bool holds_clip = false;  // the pose in the memory is of the clip that makes up this one alone
};

/// Stages palette, split_palette and combinations, with the stamps of the palettes. A palette of the same bits as in
/// the frame before is neither written nor split nor combined again (P19). in   model[J];   wanted[skins]  needed by
/// this frame; empty = all that are planned cost O(joints of the skins), no allocation
void make_palettes(const Plan& plan, std::span<const Affine> model, std::span<const bool> wanted, const FrameStep& step,
                   FrameWork& work) noexcept;

}  // namespace sinew
