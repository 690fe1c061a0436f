// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <bitset>

#include "runtime/pose_program/pose_program.h"

namespace sinew {

/// Finds the operations whose properties a later operation reads. An addition keeps the properties of its base, so its
/// layer and its reference need none. Internal to the runtime.
class ReadProperties {
 public:
  /// in   program  checked;   any  false: the caller wants no properties
  ReadProperties(PoseProgramSpan program, bool any) noexcept {
    if (!any) return;
    std::array<bool, kMostPoseOps + 1> wanted;  // for poses that later operations take, the next taken on top
    std::size_t depth = 0;
    wanted[depth++] = true;
    for (std::size_t i = program.size(); i-- > 0;) {
      const bool reads = wanted[--depth];
      read_[i] = reads;
      const bool adds = program[i].kind == PoseOpKind::add || program[i].kind == PoseOpKind::add_to_rest;
      for (std::size_t o = 0; o < operands_of(program[i]); ++o) wanted[depth++] = reads && (!adds || o == 0);
    }
  }

  bool of(std::size_t op) const noexcept { return read_[op]; }

 private:
  std::bitset<kMostPoseOps> read_;
};

}  // namespace sinew
