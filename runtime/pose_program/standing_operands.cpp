// SPDX-License-Identifier: MIT
#include "runtime/pose_program/standing_operands.h"

#include <algorithm>
#include <cstring>

namespace sinew {
namespace {

/// For each kept operation: index of the first operation that contributes to its kept operands.
using Firsts = std::array<std::uint8_t, kMostPoseOps>;

/// out  firsts  set for kept operations only
void find_firsts(PoseProgramSpan program, Firsts& firsts) noexcept {
  std::array<std::uint8_t, kMostPoseOps> starts;  // for each pose on the stack, the first operation that makes it
  std::size_t depth = 0;
  for (std::size_t i = 0; i < program.size(); ++i) {
    const std::size_t taken = operands_of(program[i]), kept = kept_operands_of(program[i]);
    if (kept > 0) firsts[i] = starts[depth - kept];
    if (taken == 0) starts[depth] = static_cast<std::uint8_t>(i);
    depth = depth - taken + 1;
  }
}

/// True if the operation reads a list of the caller.
bool reads_lists(const PoseOp& op, std::size_t shared_masks) noexcept {
  return op.kind == PoseOpKind::external || op.kind == PoseOpKind::override_joints ||
         op.kind == PoseOpKind::procedure || (op.mask != PoseOp::kNoMask && op.mask >= shared_masks);
}

bool have_same_operands(PoseProgramSpan ops, const KeptOperands& place, const LastProgram& last) noexcept {
  if (!place.is_there || std::size_t{place.end} - place.first != ops.size()) return false;
  if (std::memcmp(ops.data(), last.ops.data() + place.first, ops.size_bytes()) != 0) return false;
  return last.same_content ||
         std::none_of(ops.begin(), ops.end(), [&](const PoseOp& op) { return reads_lists(op, last.shared_masks); });
}

}  // namespace

void StandingOperands::find(PoseProgramSpan program, const ReadProperties& properties, const LastProgram& last,
                            std::span<KeptOperands> kept) noexcept {
  Firsts firsts;
  find_firsts(program, firsts);
  std::bitset<kMostPoseOps> taken, waits;  // places that are in use; operations that still need a place
  for (std::size_t i = program.size(); i-- > 0;) {
    if (skipped_[i] || kept_operands_of(program[i]) == 0) continue;
    const PoseProgramSpan ops = program.subspan(firsts[i], i - firsts[i]);
    bool stands = is_transition(program[i].kind) && program[i].time_s >= 1.0;
    places_[i] = 0;
    for (std::size_t p = 0; !last.ops.empty() && !stands && p < kept.size(); ++p) {
      stands = !taken[p] && (kept[p].has_properties || !properties.of(i)) && have_same_operands(ops, kept[p], last);
      if (!stands) continue;
      taken[p] = true;
      places_[i] = static_cast<std::uint8_t>(p);
      kept[p] = {firsts[i], static_cast<std::uint8_t>(i), kept[p].has_properties, true};
    }
    waits[i] = !stands;
    standing_[i] = stands;
    for (std::size_t o = firsts[i]; stands && o < i; ++o) skipped_[o] = true;
  }
  std::size_t place = 0;
  for (std::size_t i = 0; waits.any() && i < program.size(); ++i) {
    if (!waits[i]) continue;
    while (taken[place]) ++place;
    places_[i] = static_cast<std::uint8_t>(place);
    kept[place] = {firsts[i], static_cast<std::uint8_t>(i), properties.of(i), true};
    taken[place] = true;
  }
  for (std::size_t p = 0; p < kept.size(); ++p)
    if (!taken[p]) kept[p].is_there = false;
}

}  // namespace sinew
