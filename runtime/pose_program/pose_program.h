// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/pose/add_pose.h"
#include "runtime/pose_program/pose_op.h"

namespace sinew {

/// Operations in postfix order: those that make an operand stand before the one that takes it. At most 255. A program
/// is plain bytes: copy it, compare it, hash it, store it.
using PoseProgramSpan = std::span<const PoseOp>;
inline constexpr std::size_t kMostPoseOps = 255;

/// Sizes of the tables that a program may index, and of its memory. find_fault refuses programs that go beyond.
struct PoseProgramLimits {
  std::size_t clips = 0, externals = 0, masks = 0, overrides = 0, procedures = 0;
  bool mirror = false;                  ///< mirror tables are there
  std::size_t slots = 0;                ///< poses that memory has room for
  std::size_t kept = 0;                 ///< as PoseProgramRoom::kept
  bool overlays_in_model_space = true;  ///< memory has room for their rotations
};

/// The memory that programs need, and the tables that they refer to: the most of each.
struct PoseProgramRoom {
  std::uint32_t ops = 0;
  std::uint32_t slots = 0;                                                ///< poses on the stack at once
  std::uint32_t externals = 0, overrides = 0, masks = 0, procedures = 0;  ///< of the caller
  std::uint32_t overridden_joints = 0;                                    ///< of all overrides together
  bool overlays_in_model_space = false;
  std::uint32_t kept = 0;  ///< operations that keep their operands' work: transitions and `cached`

  friend bool operator==(const PoseProgramRoom&, const PoseProgramRoom&) = default;
};

/// The first fault of a program.
struct PoseProgramFault {
  ErrorCode code = ErrorCode::ok;
  std::size_t op = 0;     ///< index of the operation; the number of operations for a fault of the program as a whole
  const char* rule = "";  ///< in words
};

/// Poses that lie on the stack at once, at most: the memory that a program needs.
/// in   program  of any operations; one that lacks operands answers what it reaches until then
/// cost O(ops), no allocation
SINEW_API std::size_t pose_slots(PoseProgramSpan program) noexcept;

/// The room that a program needs. Tables are as long as its largest index asks for, so masks of the plan count too.
/// `overridden_joints` is left at 0, since a program does not say how many joints an override has.
/// cost O(ops), no allocation
SINEW_API PoseProgramRoom room_of(PoseProgramSpan program) noexcept;

/// The room that either of two programs needs.
SINEW_API PoseProgramRoom larger(const PoseProgramRoom& a, const PoseProgramRoom& b) noexcept;

/// err  code  index_out_of_range (of clips, externals, masks, overrides, procedures), not_finite, negative_weight,
///      not_a_fraction (a share, threshold or progress; no steps), not_in_needs (mirrored without tables, more kept
///      operations), unsupported (an unknown kind), size_mismatch (operands, length, slots)
/// cost O(ops), no allocation
SINEW_API PoseProgramFault find_fault(PoseProgramSpan program, const PoseProgramLimits& limits) noexcept;
inline ErrorCode check(PoseProgramSpan program, const PoseProgramLimits& limits) noexcept {
  return find_fault(program, limits).code;
}

/// Names the operation and the rule ("operation 3 (overlay): it takes more poses than those before it leave"). Empty
/// without a fault.
SINEW_API std::string describe(const PoseProgramFault& fault, PoseProgramSpan program);

/// "sample", "mean", ...; "?" for a kind that is not known.
SINEW_API const char* name_of(PoseOpKind kind) noexcept;

/// A program in the making, in memory of its own: nothing is allocated. Operations beyond kMostPoseOps are counted and
/// left out, and `is_complete` tells.
class PoseProgram {
 public:
  PoseProgram& rest(float weight = 1.0f, std::uint8_t mask = PoseOp::kNoMask) noexcept {
    return push({.weight = weight, .mask = mask, .kind = PoseOpKind::rest});
  }
  PoseProgram& sample(std::uint32_t clip, double time_s, float weight = 1.0f,
                      std::uint8_t mask = PoseOp::kNoMask) noexcept {
    return push({time_s, weight, index_of(clip), mask, PoseOpKind::sample});
  }
  PoseProgram& sample_mirrored(std::uint32_t clip, double time_s, float weight = 1.0f,
                               std::uint8_t mask = PoseOp::kNoMask) noexcept {
    return push({time_s, weight, index_of(clip), mask, PoseOpKind::sample_mirrored});
  }
  PoseProgram& external(std::uint32_t pose, float weight = 1.0f, std::uint8_t mask = PoseOp::kNoMask) noexcept {
    return push({.weight = weight, .index = index_of(pose), .mask = mask, .kind = PoseOpKind::external});
  }
  /// in   threshold  in (0, 1]: weights that sum to less are filled up with the rest pose, others are normalised
  PoseProgram& mean(std::size_t operands, float weight = 1.0f, double threshold = 1.0,
                    std::uint8_t mask = PoseOp::kNoMask) noexcept {
    return push({threshold, weight, index_of(operands), mask, PoseOpKind::mean});
  }
  PoseProgram& overlay(float weight = 1.0f, std::uint8_t mask = PoseOp::kNoMask) noexcept {
    return push({.weight = weight, .mask = mask, .kind = PoseOpKind::overlay});
  }
  PoseProgram& overlay_model(float weight = 1.0f, std::uint8_t mask = PoseOp::kNoMask) noexcept {
    return push({.weight = weight, .mask = mask, .kind = PoseOpKind::overlay_model});
  }
  PoseProgram& add_to_rest(float weight = 1.0f, DeltaFrame frame = DeltaFrame::parent) noexcept {
    return push({.weight = weight, .index = index_of(std::size_t(frame)), .kind = PoseOpKind::add_to_rest});
  }
  PoseProgram& add(float weight = 1.0f, DeltaFrame frame = DeltaFrame::parent) noexcept {
    return push({.weight = weight, .index = index_of(std::size_t(frame)), .kind = PoseOpKind::add});
  }
  PoseProgram& override_joints(std::uint32_t joints, double share = 1.0, float weight = 1.0f) noexcept {
    return push({share, weight, index_of(joints), PoseOp::kNoMask, PoseOpKind::override_joints});
  }
  PoseProgram& procedure(std::uint32_t index, double share = 1.0, float weight = 1.0f) noexcept {
    return push({share, weight, index_of(index), PoseOp::kNoMask, PoseOpKind::procedure});
  }
  /// in   progress  [0, 1];   steps  of the duration, >= 1
  PoseProgram& inertialize(double progress, std::uint32_t steps, float weight = 1.0f,
                           std::uint8_t mask = PoseOp::kNoMask) noexcept {
    return push({progress, weight, index_of(steps), mask, PoseOpKind::inertialize});
  }
  PoseProgram& dead_blend(double progress, std::uint32_t steps, float weight = 1.0f,
                          std::uint8_t mask = PoseOp::kNoMask) noexcept {
    return push({progress, weight, index_of(steps), mask, PoseOpKind::dead_blend});
  }
  PoseProgram& cached(float weight = 1.0f, std::uint8_t mask = PoseOp::kNoMask) noexcept {
    return push({.weight = weight, .mask = mask, .kind = PoseOpKind::cached});
  }
  PoseProgram& push(const PoseOp& op) noexcept {
    if (count_ < kMostPoseOps) ops_[count_] = op;
    ++count_;
    return *this;
  }

  void clear() noexcept { count_ = 0; }
  bool is_complete() const noexcept { return count_ <= kMostPoseOps; }
  PoseProgramSpan ops() const noexcept { return {ops_.data(), count_ < kMostPoseOps ? count_ : kMostPoseOps}; }

 private:
  /// An index too large for an operation stays out of range, so that the check refuses it.
  static constexpr std::uint16_t index_of(std::size_t index) noexcept {
    return index < 0xFFFF ? static_cast<std::uint16_t>(index) : std::uint16_t{0xFFFF};
  }

  std::array<PoseOp, kMostPoseOps> ops_{};
  std::size_t count_ = 0;
};

}  // namespace sinew
