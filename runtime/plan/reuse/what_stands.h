// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/plan/frame_buffer.h"
#include "runtime/plan/frame_input.h"
#include "runtime/plan/frame_tables.h"

namespace sinew {

/// World matrices of the last run into the memory that are still valid for this frame.
enum class StandingMatrices : std::uint8_t {
  none,
  of_unmoved_joints,  ///< only matrices of joints that no clip moves
  all
};

/// The parts of the memory that stand: a comparison of inputs shows that they are still valid. By default nothing
/// stands.
struct WhatStands {
  bool all = false;               ///< the memory holds the result of the same input
  bool all_since_before = false;  ///< the character's previous frame had the same input, perhaps in other memory
  StandingMatrices matrices = StandingMatrices::none;
  bool base_pose = false;  ///< the same single clip plays in both frames, so only its tracks are sampled
};

/// The last run that used some frame memory.
struct LastFrame {
  const LastInput& input;
  const FrameTables& tables;  ///< tables in that memory
};

/// True if the last run had this input, bit for bit.     cost O(layers + weights + instances)
/// in   input  not checked: its lists may have wrong lengths
bool had_same_input(const LastFrame& last, const FrameInput& input) noexcept;

/// Compares the input with those of earlier frames.
/// in   input   checked;   last  run into the frame's memory;   before  the character's last run, perhaps into other
///      memory;   had_it  had_same_input of the last run
/// cost O(layers + weights + instances), no allocation. Internal to plan/
WhatStands find_what_stands(const CompiledPlan& plan, const FrameInput& input, const LastFrame& last,
                            const LastFrame& before, bool had_it) noexcept;

/// Stores the input of an evaluated frame for later comparison. If it has more layers than there is room for, nothing
/// stands in the next frame.
void remember(const FrameInput& input, const FrameTables& tables, LastInput& last) noexcept;

}  // namespace sinew
