// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/plan/frame_buffer.h"
#include "runtime/plan/frame_input.h"
#include "runtime/plan/frame_tables.h"
#include "runtime/pose_program/standing_operands.h"

namespace sinew {

/// World matrices of the last run into the memory that are still valid for this frame.
enum class StandingMatrices : std::uint8_t {
  none,
  of_unmoved_joints,  ///< of joints that no clip moves
  all
};

/// Parts of the memory that need not be evaluated again, as far as the inputs say. The default: nothing stands.
struct WhatStands {
  bool all = false;               ///< the memory holds the result of this very input
  bool all_since_before = false;  ///< the character's frame before had this input too, perhaps in other memory
  StandingMatrices matrices = StandingMatrices::none;
  LastProgram program = {};  ///< whose kept operands the memory has
  bool base_pose = false;    ///< the pose is of the one clip that plays now too: only its tracks need be sampled
};

/// The last run into some memory.
struct LastFrame {
  const LastInput& input;
  const FrameTables& tables;  ///< of that memory
};

/// True if the last run had this input, bit for bit.     cost O(layers + weights + instances)
/// in   input  lists of any content, whose lengths may be wrong
bool had_same_input(const LastFrame& last, const FrameInput& input) noexcept;

/// Compares the input with those of earlier frames.
/// in   input   checked;   last  run into the frame's memory;   before  the character's last run, perhaps into other
///      memory;   had_it  had_same_input of the last run
/// cost O(layers + weights + instances), no allocation. Internal to plan/
WhatStands find_what_stands(const CompiledPlan& plan, const FrameInput& input, const LastFrame& last,
                            const LastFrame& before, bool had_it) noexcept;

/// Keeps the input of a frame that was evaluated. More layers than there is room for are not kept: then nothing stands
/// for the next frame.
void remember(const FrameInput& input, const FrameTables& tables, LastInput& last) noexcept;

}  // namespace sinew
