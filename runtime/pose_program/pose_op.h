// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>

namespace sinew {

/// An operation on a stack of poses. It takes its operands from the stack and leaves one pose there. Each pose comes
/// with its morph weights and properties.
enum class PoseOpKind : std::uint8_t {
  rest,             ///< pushes the rest pose
  sample,           ///< pushes clip `index` at `time_s`
  sample_mirrored,  ///< as sample, with left and right exchanged
  rest_mirrored,    ///< pushes the rest pose with left and right exchanged, the reference of a mirrored additive clip
  external,         ///< pushes pose `index` of the caller: a ragdoll, the network, another skeleton's motion
  mean,             ///< weighted mean of the `index` topmost poses; no operands give the rest pose
  overlay,          ///< lays the topmost pose over the pose below it, by weight and mask
  overlay_model,    ///< as overlay, but rotations are mixed in model space: an aim stays level while the hips sway
  add_to_rest,      ///< adds the topmost pose minus the rest pose to the pose below
  add,              ///< adds layer minus reference to base; the stack holds base, layer, reference (topmost)
  override_joints,  ///< sets joints of the topmost pose to the transforms of override `index`, by weight
  procedure,        ///< lets procedure `index` of the caller change the topmost pose: IK, springs, a solver of its own
  inertialize,      ///< transition: adds the source's offset from the target at the start, which decays
  dead_blend,       ///< transition: fades the source, which moves on by its velocity, into the target
  cached,  ///< keeps the topmost pose: later frames reuse it as long as the operations that make it are the same
};

/// One operation. `weight` and `mask` apply when a later mean, overlay (as upper pose) or addition (as layer) takes its
/// pose. The share of override_joints and procedure is in `time_s`.
/// Operands of transitions, the lowest first: the target's pose now, the source's pose at the start, and the source's
/// pose one step before. `inertialize` also takes the target's pose at the start and one step before. Weights and masks
/// of these operands are ignored.
struct PoseOp {
  double time_s = 0.0;  ///< sample: seconds in the clip;  mean: its threshold;  override_joints, procedure: its share;
                        ///< transitions: progress in [0, 1], the share of the duration that has passed
  float weight = 1.0f;  ///< finite, >= 0; below 0 only as the layer of an addition, which then subtracts (add_pose.h)
  std::uint16_t index = 0;      ///< of a clip, an external pose, an override or a procedure; mean: number of operands;
                                ///< additions: DeltaFrame;  transitions: steps in the duration, >= 1. A step is the
                                ///< time from "one step before" to the start; 0.1 to 1 ms measures velocities well
  std::uint8_t mask = kNoMask;  ///< index of a mask that multiplies `weight`
  PoseOpKind kind = PoseOpKind::rest;

  static constexpr std::uint8_t kNoMask = 255;

  friend bool operator==(const PoseOp&, const PoseOp&) = default;
};
static_assert(sizeof(PoseOp) == 16, "programs are compared, stored and sent as bytes");

/// Number of poses that an operation takes from the stack.
constexpr std::size_t operands_of(const PoseOp& op) noexcept {
  switch (op.kind) {
    case PoseOpKind::mean: return op.index;
    case PoseOpKind::overlay:
    case PoseOpKind::overlay_model:
    case PoseOpKind::add_to_rest: return 2;
    case PoseOpKind::add: return 3;
    case PoseOpKind::override_joints:
    case PoseOpKind::procedure:
    case PoseOpKind::cached: return 1;
    case PoseOpKind::dead_blend: return 3;
    case PoseOpKind::inertialize: return 5;
    default: return 0;
  }
}

/// Number of topmost operands that stay the same while the operation lasts. Frames keep the numbers computed from them.
constexpr std::size_t kept_operands_of(const PoseOp& op) noexcept {
  switch (op.kind) {
    case PoseOpKind::cached: return 1;
    case PoseOpKind::dead_blend: return 2;
    case PoseOpKind::inertialize: return 4;
    default: return 0;
  }
}

constexpr bool is_transition(PoseOpKind kind) noexcept {
  return kind == PoseOpKind::inertialize || kind == PoseOpKind::dead_blend;
}

/// Programs can only name clips below this index. Larger indices are refused; PoseProgram stores them as 0xFFFF.
inline constexpr std::size_t kMostClipsOfPrograms = 0xFFFF;

}  // namespace sinew
