// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/plan/frame_buffer.h"
#include "runtime/plan/frame_input.h"
#include "runtime/plan/frame_tables.h"

namespace sinew {

/// World matrices in the frame's memory that hold for the frame to come.
enum class CurrentMatrices : std::uint8_t {
  none,
  of_unmoved_joints,  ///< of those that no clip moves
  all
};

/// What a frame has in common with those before it, as far as the inputs tell. Stages leave out what is there already.
struct FrameChanges {
  bool nothing = false;               ///< the memory holds the result of this very input: no stage runs
  bool nothing_since_before = false;  ///< the frame before of the character, perhaps in other memory, had this input
  CurrentMatrices current_matrices = CurrentMatrices::none;
  bool same_clip = false;    ///< the pose in the memory is of the clip that makes up this one alone
  bool mixes_poses = false;  ///< several layers, or a frame between updates: the mean rounds joints that rest
};

/// A frame in the making, beside the one before it of the same character. Both may be in the same memory.
struct FrameStep {
  FrameMemory memory;
  const FrameTables& tables;
  FrameMemory memory_before;
  const FrameTables& tables_before;
  std::uint64_t number = 0;  ///< FrameResult::frame
  FrameChanges changes;
  bool past_caches = false;  ///< FrameBuffer::write_past_caches
};

/// The last run into some memory: its input, and what else is known of it.
struct LastFrame {
  const LastInput& input;
  const FrameTables& tables;  ///< of that memory
};

/// Whether the last run had this input, bit for bit.     cost O(layers + weights + instances)
bool had_same_input(const LastFrame& last, const FrameInput& input) noexcept;

/// in   input   checked;   last  run into the frame's memory;   before  run of the character, perhaps into other memory
/// cost O(layers + weights + instances), no allocation. Internal to plan/
FrameChanges find_changes(const CompiledPlan& plan, const FrameInput& input, const LastFrame& last,
                          const LastFrame& before) noexcept;

/// Keeps the input for the changes of later frames. More layers than there is room for are not kept; then the next
/// frame is taken for a new one.
void remember(const FrameInput& input, const FrameTables& tables, LastInput& last) noexcept;

}  // namespace sinew
