// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>

#include "runtime/graph/graph_definition.h"
#include "runtime/graph/graph_time.h"

namespace sinew {

/// The state of a character is a block of these, one behind the other, at offsets that the definition knows. Internal
/// to graph/.

/// At the start of the block.
struct GraphHeader {
  GraphTicks now = 0;          ///< since the start, backwards too
  double rest_s = 0.0;         ///< of time steps, less than half a tick
  std::uint64_t triggers = 0;  ///< by parameter: set, and not used up yet
  std::uint32_t signature = 0;
  GraphIndex asked_machine = kNoGraphIndex, asked_state = kNoGraphIndex;  ///< of request_state
};
static_assert(sizeof(GraphHeader) == 32);
inline constexpr std::size_t kMostGraphTriggers = 64;  ///< parameters from here on cannot be triggers

/// Place of a clip or blend space within its period. Clips count 2^-20 of a tick, spaces 2^-58 of a round: whole
/// numbers, so that sums are exact.
struct MotionState {
  std::int64_t position = 0;
  std::int32_t rounds = 0;
  std::uint32_t started = 0;  ///< not 0: it has moved, so events at its place have been told
};
static_assert(sizeof(MotionState) == 16);
inline constexpr int kClipBits = 20, kPhaseBits = 58;
inline constexpr double kTicksOfClip = 0x1p-20, kRoundsOfPhase = 0x1p-58;  ///< of one unit
inline constexpr std::int64_t kPhasePeriod = std::int64_t{1} << kPhaseBits;

/// Of a select. The child's state follows.
struct SelectState {
  GraphIndex child = 0;
  std::uint16_t unused[3] = {};
};
static_assert(sizeof(SelectState) == 8);

/// Of a machine. Slots follow: the oldest state first, the one that is being entered or active last.
struct MachineState {
  std::uint16_t depth = 0;  ///< slots in use
  std::uint16_t unused[3] = {};
};
static_assert(sizeof(MachineState) == 8);

/// A state that is active or fades. The state of its node follows.
struct SlotState {
  GraphTicks time = 0;                    ///< since it was entered: the time of its fade as well
  GraphIndex state = 0;                   ///< of the machine
  GraphIndex transition = kNoGraphIndex;  ///< that led to it
  GraphIndex from = kNoGraphIndex;        ///< state of the machine that it left
  std::uint16_t whole = 0;                ///< not 0: it has no fade, or its fade is done
};
static_assert(sizeof(SlotState) == 16);

/// Bytes of the parameters' values that a slot keeps, a multiple of 8.
inline std::uint32_t kept_parameter_bytes(std::size_t parameters) noexcept {
  return static_cast<std::uint32_t>((parameters * sizeof(float) + 7) / 8 * 8);
}

template <class Block>
Block& block_at(std::byte* memory) noexcept {
  return *reinterpret_cast<Block*>(memory);
}

/// The slots of one machine. Of machines that inertialize or dead-blend, each slot also keeps its state as it started,
/// and the parameters at that moment.
struct MachineSlots {
  std::byte* memory;  ///< of the machine
  std::size_t stride, largest_state;

  MachineState& head() const noexcept { return block_at<MachineState>(memory); }
  std::byte* at(std::size_t slot) const noexcept { return memory + sizeof(MachineState) + slot * stride; }
  SlotState& slot(std::size_t index) const noexcept { return block_at<SlotState>(at(index)); }
  /// The memory in which the node of a slot lies.
  std::byte* inside(std::size_t slot) const noexcept { return at(slot) + sizeof(SlotState); }
  std::byte* started(std::size_t slot) const noexcept { return inside(slot) + largest_state; }
  float* started_parameters(std::size_t slot) const noexcept {
    return reinterpret_cast<float*>(started(slot) + largest_state);
  }
  std::size_t depth() const noexcept { return head().depth; }
  SlotState& top() const noexcept { return slot(depth() - 1); }
};

}  // namespace sinew
