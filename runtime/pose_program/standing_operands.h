// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/pose_program/pose_program.h"
#include "runtime/pose_program/read_properties.h"

namespace sinew {

/// An earlier run's kept operation, whose numbers lie in its place in memory (PoseSlots::kept).
struct KeptOperands {
  std::uint8_t first = 0, end = 0;  ///< the operations of that run's program which made the operands
  bool has_properties = false;
  bool is_there = false;
};

/// The last run into some memory, as far as its kept operands may serve another run.
struct LastProgram {
  PoseProgramSpan ops;        ///< empty: nothing is kept
  bool same_content = false;  ///< versions promise the content of all lists of the caller
  std::size_t shared_masks = 0;
};

/// Compares the operands of kept operations (kept_operands_of) with those of the last run, byte by byte, and finds the
/// operations that need not run. Transitions that are over need no operands either. Internal to the runtime.
class StandingOperands {
 public:
  /// in   program  checked;   kept  places in memory; empty = the program has no kept operations
  /// out  kept     of this run
  /// cost O(ops), and O(ops) again for each kept operation; no allocation
  StandingOperands(PoseProgramSpan program, const ReadProperties& properties, const LastProgram& last,
                   std::span<KeptOperands> kept) noexcept {
    if (!kept.empty()) find(program, properties, last, kept);
  }

  bool skips(std::size_t op) const noexcept { return skipped_[op]; }
  bool stands(std::size_t op) const noexcept { return standing_[op]; }
  /// Of a kept operation that runs.
  std::uint8_t place(std::size_t op) const noexcept { return places_[op]; }

 private:
  void find(PoseProgramSpan program, const ReadProperties& properties, const LastProgram& last,
            std::span<KeptOperands> kept) noexcept;

  std::bitset<kMostPoseOps> skipped_, standing_;
  std::array<std::uint8_t, kMostPoseOps> places_;  // of kept operations that run
};

}  // namespace sinew
