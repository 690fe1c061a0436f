// SPDX-License-Identifier: MIT
#include "runtime/pose_program/op_shares.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "runtime/base/contract.h"

namespace sinew {
namespace {

float weight_of_mean(PoseProgramSpan program, const PoseOp& mean, std::span<const std::uint8_t> operands) noexcept {
  double sum = 0.0;
  for (const std::uint8_t operand : operands) sum += static_cast<double>(program[operand].weight);
  return static_cast<float>(std::max(sum, mean.time_s));
}

/// Share of an operand in the pose of the operation that takes it.
/// in   place  0 for the lowest operand;   weight  its weight;   upper  weight of the topmost operand;   mean_weight  of
///      all operands of a mean
float share_of_operand(PoseOpKind kind, std::size_t place, float weight, float upper, float mean_weight) noexcept {
  switch (kind) {
    case PoseOpKind::mean: return weight / mean_weight;
    case PoseOpKind::overlay:
    case PoseOpKind::overlay_model: return place == 1 ? std::min(1.0f, weight) : 1.0f - std::min(1.0f, upper);
    case PoseOpKind::add_to_rest:
    case PoseOpKind::add: return place == 0 ? 1.0f : place == 1 ? weight : 0.0f;
    default: return place == 0 ? 1.0f : 0.0f;
  }
}

}  // namespace

void find_op_shares(PoseProgramSpan program, std::span<float> shares) noexcept {
  CONTRACT(shares.size() >= program.size());
  // Forwards: the operation that takes each pose, and the pose's share in it.
  std::array<std::uint8_t, kMostPoseOps> stack{}, taker{};
  std::size_t depth = 0;
  for (std::size_t i = 0; i < program.size(); ++i) {
    const PoseOp& op = program[i];
    const std::size_t count = operands_of(op);
    depth -= count;
    const std::span<const std::uint8_t> operands = std::span<const std::uint8_t>(stack).subspan(depth, count);
    const float mean_weight = op.kind == PoseOpKind::mean ? weight_of_mean(program, op, operands) : 1.0f;
    for (std::size_t k = 0; k < count; ++k) {
      taker[operands[k]] = static_cast<std::uint8_t>(i);
      shares[operands[k]] =
          share_of_operand(op.kind, k, program[operands[k]].weight, program[operands.back()].weight, mean_weight);
    }
    stack[depth++] = static_cast<std::uint8_t>(i);
  }
  // Backwards: takers come after their operands.
  if (!program.empty()) shares[program.size() - 1] = 1.0f;
  for (std::size_t i = program.size(); i-- > 1;) shares[i - 1] *= shares[taker[i - 1]];
}

}  // namespace sinew
