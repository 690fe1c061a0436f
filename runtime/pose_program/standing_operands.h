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

/// A kept operation of an earlier run. Its numbers are in the memory place with the same index (PoseSlots::kept).
struct KeptOperands {
  std::uint8_t first = 0, end = 0;  ///< range of operations in that run's program that made the operands
  bool has_properties = false;
  bool is_there = false;
};

/// The last run into some memory: the facts that decide whether its kept numbers can be reused.
struct LastProgram {
  PoseProgramSpan ops;        ///< empty: nothing is kept
  bool same_content = false;  ///< versions promise that all lists of the caller have the same content as in that run
  std::size_t shared_masks = 0;
};

/// Finds the operations that need not run. The operands of kept operations (kept_operands_of) are compared with those
/// of the last run, byte by byte. Finished transitions need no operands either. Internal to the runtime.
class StandingOperands {
 public:
  /// in   program  checked;   kept  entries of the last run; empty = the program has no kept operations
  /// out  kept     entries of this run
  /// cost O(ops), and O(ops) again for each kept operation; no allocation
  StandingOperands(PoseProgramSpan program, const ReadProperties& properties, const LastProgram& last,
                   std::span<KeptOperands> kept) noexcept {
    if (!kept.empty()) find(program, properties, last, kept);
  }

  bool skips(std::size_t op) const noexcept { return skipped_[op]; }
  bool stands(std::size_t op) const noexcept { return standing_[op]; }
  /// Memory place of a kept operation that runs.
  std::uint8_t place(std::size_t op) const noexcept { return places_[op]; }

 private:
  void find(PoseProgramSpan program, const ReadProperties& properties, const LastProgram& last,
            std::span<KeptOperands> kept) noexcept;

  std::bitset<kMostPoseOps> skipped_, standing_;
  std::array<std::uint8_t, kMostPoseOps> places_;  // memory places of kept operations that run
};

}  // namespace sinew
