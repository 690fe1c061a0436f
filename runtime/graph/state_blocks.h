// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>

#include "runtime/graph/graph_definition.h"
#include "runtime/graph/graph_time.h"

namespace sinew {

/// The state of a character consists of these blocks, one after the other. GraphDefinition knows their offsets.
/// Internal to graph/.

/// First block of the state.
struct GraphHeader {
  GraphTicks now = 0;          ///< clock of the graph: time since its start; runs backwards, too
  double rest_s = 0.0;         ///< remainder of time steps, less than half a tick
  std::uint64_t triggers = 0;  ///< bit p: trigger parameter p is set and not used up yet
  std::uint32_t signature = 0;
  GraphIndex asked_machine = kNoGraphIndex, asked_state = kNoGraphIndex;  ///< pending request_state
};
static_assert(sizeof(GraphHeader) == 32);
inline constexpr std::size_t kMostGraphTriggers = 64;  ///< only parameters below this index can be triggers

/// Position of a clip or blend space within its period. The unit is 2^-20 of a tick for clips and 2^-58 of a round for
/// spaces. Whole numbers make sums exact.
struct MotionState {
  std::int64_t position = 0;
  std::int32_t rounds = 0;
  std::uint32_t started = 0;  ///< not 0: it has moved, so events at its position have been reported
};
static_assert(sizeof(MotionState) == 16);
inline constexpr int kClipBits = 20, kPhaseBits = 58;
inline constexpr double kTicksOfClip = 0x1p-20, kRoundsOfPhase = 0x1p-58;  ///< size of a position unit
inline constexpr std::int64_t kPhasePeriod = std::int64_t{1} << kPhaseBits;

/// State of a select. The state of its chosen child follows.
struct SelectState {
  GraphIndex child = 0;
  std::uint16_t unused[3] = {};
};
static_assert(sizeof(SelectState) == 8);

/// State of a machine. Its slots follow: the oldest state first, the active state last.
struct MachineState {
  std::uint16_t depth = 0;  ///< slots in use
  std::uint16_t unused[3] = {};
};
static_assert(sizeof(MachineState) == 8);

/// A slot: a state that is active or fades out. The state of its node follows.
struct SlotState {
  GraphTicks time = 0;                    ///< time since the state was entered, which is also the time of its fade
  GraphIndex state = 0;                   ///< index within the machine
  GraphIndex transition = kNoGraphIndex;  ///< transition that entered the state
  GraphIndex from = kNoGraphIndex;        ///< state that the transition left
  std::uint16_t whole = 0;                ///< not 0: it has no fade, or its fade has ended
};
static_assert(sizeof(SlotState) == 16);

/// Bytes for the parameter values that a slot stores, a multiple of 8.
inline std::uint32_t kept_parameter_bytes(std::size_t parameters) noexcept {
  return static_cast<std::uint32_t>((parameters * sizeof(float) + 7) / 8 * 8);
}

template <class Block>
Block& block_at(std::byte* memory) noexcept {
  return *reinterpret_cast<Block*>(memory);
}

/// The slots of one machine. If a machine inertializes or dead-blends, each slot also stores two things: its node's
/// state at the start, and the parameters at that moment.
struct MachineSlots {
  std::byte* memory;  ///< memory of the machine, from its MachineState on
  std::size_t stride, largest_state;

  MachineState& head() const noexcept { return block_at<MachineState>(memory); }
  std::byte* at(std::size_t slot) const noexcept { return memory + sizeof(MachineState) + slot * stride; }
  SlotState& slot(std::size_t index) const noexcept { return block_at<SlotState>(at(index)); }
  /// Start of the memory that holds the state of the slot's node.
  std::byte* inside(std::size_t slot) const noexcept { return at(slot) + sizeof(SlotState); }
  std::byte* started(std::size_t slot) const noexcept { return inside(slot) + largest_state; }
  float* started_parameters(std::size_t slot) const noexcept {
    return reinterpret_cast<float*>(started(slot) + largest_state);
  }
  std::size_t depth() const noexcept { return head().depth; }
  SlotState& top() const noexcept { return slot(depth() - 1); }
};

}  // namespace sinew
