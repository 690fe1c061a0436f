// SPDX-License-Identifier: MIT
#include "runtime/pose_program/pose_program.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace sinew {
namespace {

constexpr const char* kNames[] = {"rest",        "sample",     "sample_mirrored", "rest_mirrored",
                                  "external",    "mean",       "overlay",         "overlay_model",
                                  "add_to_rest", "add",        "override_joints", "procedure",
                                  "inertialize", "dead_blend", "cached"};
constexpr std::size_t kKinds = std::size(kNames);

bool is_kind(PoseOpKind kind) noexcept { return static_cast<std::size_t>(kind) < kKinds; }

struct OpRule {
  ErrorCode code;
  const char* text;
};
constexpr OpRule kKept{ErrorCode::ok, ""};

/// The rule that an operation breaks on its own, independent of the stack.
OpRule broken_rule(const PoseOp& op, const PoseProgramLimits& limits) noexcept {
  const bool samples = op.kind == PoseOpKind::sample || op.kind == PoseOpKind::sample_mirrored;
  const bool mirrors = op.kind == PoseOpKind::sample_mirrored || op.kind == PoseOpKind::rest_mirrored;
  const bool adds = op.kind == PoseOpKind::add || op.kind == PoseOpKind::add_to_rest;
  const bool has_share = op.kind == PoseOpKind::override_joints || op.kind == PoseOpKind::procedure;
  if (!is_kind(op.kind)) return {ErrorCode::unsupported, "the kind of operation is not known"};
  if (!std::isfinite(op.weight)) return {ErrorCode::not_finite, "its weight is not finite"};
  if (!std::isfinite(op.time_s)) return {ErrorCode::not_finite, "its time is not finite"};
  if (op.mask != PoseOp::kNoMask && op.mask >= limits.masks)
    return {ErrorCode::index_out_of_range, "there is no mask of that index"};
  if (samples && op.index >= limits.clips) return {ErrorCode::index_out_of_range, "there is no clip of that index"};
  if (op.kind == PoseOpKind::external && op.index >= limits.externals)
    return {ErrorCode::index_out_of_range, "there is no external pose of that index"};
  if (op.kind == PoseOpKind::override_joints && op.index >= limits.overrides)
    return {ErrorCode::index_out_of_range, "there is no override of that index"};
  if (op.kind == PoseOpKind::procedure && op.index >= limits.procedures)
    return {ErrorCode::index_out_of_range, "there is no procedure of that index"};
  if (has_share && !(op.time_s >= 0.0 && op.time_s <= 1.0))
    return {ErrorCode::not_a_fraction, "its share lies in [0, 1]"};
  if (is_transition(op.kind) && !(op.time_s >= 0.0 && op.time_s <= 1.0))
    return {ErrorCode::not_a_fraction, "the progress of a transition lies in [0, 1]"};
  if (is_transition(op.kind) && op.index == 0)
    return {ErrorCode::not_a_fraction, "a transition takes at least one step"};
  if (adds && op.index > static_cast<std::uint16_t>(DeltaFrame::joint))
    return {ErrorCode::unsupported, "an addition is in the parent's frame or the joint's"};
  if (mirrors && !limits.mirror) return {ErrorCode::not_in_needs, "nothing says how the skeleton is mirrored"};
  if (op.kind == PoseOpKind::overlay_model && !limits.overlays_in_model_space)
    return {ErrorCode::not_in_needs, "the memory has no room for rotations in model space"};
  if (op.kind == PoseOpKind::mean && !(op.time_s > 0.0 && op.time_s <= 1.0))
    return {ErrorCode::not_a_fraction, "the threshold of a mean lies in (0, 1]"};
  return kKept;
}

/// True if an addition takes the pose of operation `i` as its layer.
bool is_added(PoseProgramSpan program, std::size_t i) noexcept {
  std::size_t above = 0;  // poses on the stack above that of operation i
  for (const PoseOp& op : program.subspan(i + 1)) {
    const std::size_t taken = operands_of(op);
    if (taken > above)
      return (op.kind == PoseOpKind::add_to_rest && above == 0) || (op.kind == PoseOpKind::add && above == 1);
    above = above - taken + 1;
  }
  return false;
}

}  // namespace

std::size_t pose_slots(PoseProgramSpan program) noexcept {
  std::size_t depth = 0, most = 0;
  for (const PoseOp& op : program) {
    if (operands_of(op) > depth) break;
    depth = depth - operands_of(op) + 1;
    most = std::max(most, depth);
  }
  return most;
}

PoseProgramRoom room_of(PoseProgramSpan program) noexcept {
  PoseProgramRoom room{.ops = static_cast<std::uint32_t>(program.size()),
                       .slots = static_cast<std::uint32_t>(pose_slots(program))};
  const auto reach = [](std::uint32_t& count, std::uint32_t index) { count = std::max(count, index + 1); };
  for (const PoseOp& op : program) {
    if (op.mask != PoseOp::kNoMask) reach(room.masks, op.mask);
    if (kept_operands_of(op) > 0) ++room.kept;
    switch (op.kind) {
      case PoseOpKind::external: reach(room.externals, op.index); break;
      case PoseOpKind::override_joints: reach(room.overrides, op.index); break;
      case PoseOpKind::procedure: reach(room.procedures, op.index); break;
      case PoseOpKind::overlay_model: room.overlays_in_model_space = true; break;
      default: break;
    }
  }
  return room;
}

PoseProgramRoom larger(const PoseProgramRoom& a, const PoseProgramRoom& b) noexcept {
  return {std::max(a.ops, b.ops),
          std::max(a.slots, b.slots),
          std::max(a.externals, b.externals),
          std::max(a.overrides, b.overrides),
          std::max(a.masks, b.masks),
          std::max(a.procedures, b.procedures),
          std::max(a.overridden_joints, b.overridden_joints),
          a.overlays_in_model_space || b.overlays_in_model_space,
          std::max(a.kept, b.kept)};
}

PoseProgramFault find_fault(PoseProgramSpan program, const PoseProgramLimits& limits) noexcept {
  if (program.size() > kMostPoseOps)
    return {ErrorCode::size_mismatch, program.size(), "a program has at most 255 operations"};
  std::size_t depth = 0, kept = 0;
  for (std::size_t i = 0; i < program.size(); ++i) {
    if (const OpRule rule = broken_rule(program[i], limits); rule.code != ErrorCode::ok)
      return {rule.code, i, rule.text};
    if (program[i].weight < 0.0f && !is_added(program, i))
      return {ErrorCode::negative_weight, i, "its weight is negative, and only the layer of an addition may subtract"};
    const std::size_t taken = operands_of(program[i]);
    if (taken > depth) return {ErrorCode::size_mismatch, i, "it takes more poses than those before it leave"};
    if (kept_operands_of(program[i]) > 0 && ++kept > limits.kept)
      return {ErrorCode::not_in_needs, i, "the memory has room for fewer transitions and cached poses"};
    depth = depth - taken + 1;
    if (depth > limits.slots) return {ErrorCode::size_mismatch, i, "the memory has room for fewer poses"};
  }
  if (depth != 1) return {ErrorCode::size_mismatch, program.size(), "exactly one pose remains at the end of a program"};
  return {};
}

std::string describe(const PoseProgramFault& fault, PoseProgramSpan program) {
  if (fault.code == ErrorCode::ok) return {};
  if (fault.op >= program.size()) return std::string("program: ") + fault.rule;
  const PoseOpKind kind = program[fault.op].kind;
  const std::string name = is_kind(kind) ? name_of(kind) : "kind " + std::to_string(static_cast<int>(kind));
  return "operation " + std::to_string(fault.op) + " (" + name + "): " + fault.rule;
}

const char* name_of(PoseOpKind kind) noexcept { return is_kind(kind) ? kNames[static_cast<std::size_t>(kind)] : "?"; }

}  // namespace sinew
