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

/// Operations in postfix order: the operations that make an operand come before the operation that takes it. At most
/// 255. A program is plain bytes: copy it, compare it, hash it, store it.
using PoseProgramSpan = std::span<const PoseOp>;
inline constexpr std::size_t kMostPoseOps = 255;

/// Sizes of the tables that a program may index, and of its memory. find_fault refuses programs that exceed them.
struct PoseProgramLimits {
  std::size_t clips = 0, externals = 0, masks = 0, overrides = 0, procedures = 0;
  bool mirror = false;                  ///< mirror tables exist
  std::size_t slots = 0, kept = 0;      ///< room of the memory, as in PoseProgramRoom
  bool overlays_in_model_space = true;  ///< the memory has room for the rotations of overlay_model
};

/// The memory that a set of programs needs, and the sizes of the tables that they index. Each number is an upper limit.
struct PoseProgramRoom {
  std::uint32_t ops = 0;
  std::uint32_t slots = 0;                                                ///< poses on the stack at once
  std::uint32_t externals = 0, overrides = 0, masks = 0, procedures = 0;  ///< of the caller
  std::uint32_t overridden_joints = 0;                                    ///< in all overrides together
  bool overlays_in_model_space = false;
  std::uint32_t kept = 0;  ///< transitions and `cached` operations, which keep numbers of their operands

  friend bool operator==(const PoseProgramRoom&, const PoseProgramRoom&) = default;
};

/// The first fault of a program.
struct PoseProgramFault {
  ErrorCode code = ErrorCode::ok;
  std::size_t op = 0;     ///< index of the operation; the number of operations if the whole program is at fault
  const char* rule = "";  ///< in words
};

/// Largest number of poses on the stack at once: the slots that a program needs.
/// in   program  unchecked; if an operation lacks operands, counting stops there
/// cost O(ops), no allocation
SINEW_API std::size_t pose_slots(PoseProgramSpan program) noexcept;

/// The room that a program needs. Each table must reach to the program's largest index, so masks of the plan count too.
/// `overridden_joints` is left at 0, since a program does not say how many joints an override has.
/// cost O(ops), no allocation
SINEW_API PoseProgramRoom room_of(PoseProgramSpan program) noexcept;

/// The larger of each number of two rooms.
SINEW_API PoseProgramRoom larger(const PoseProgramRoom& a, const PoseProgramRoom& b) noexcept;

/// err  code  index_out_of_range (of clips, externals, masks, overrides, procedures), not_finite, negative_weight
///      (but of an addition's layer), not_a_fraction (a share, threshold or progress; no steps), not_in_needs (mirrored
///      without tables, more kept operations), unsupported (an unknown kind), size_mismatch (operands, length, slots)
/// cost O(ops), no allocation
SINEW_API PoseProgramFault find_fault(PoseProgramSpan program, const PoseProgramLimits& limits) noexcept;
inline ErrorCode check(PoseProgramSpan program, const PoseProgramLimits& limits) noexcept {
  return find_fault(program, limits).code;
}

/// Names the operation and the rule ("operation 3 (overlay): it takes more poses than those before it leave"). Empty if
/// there is no fault.
SINEW_API std::string describe(const PoseProgramFault& fault, PoseProgramSpan program);

/// "sample", "mean", ...; "?" for a kind that is not known.
SINEW_API const char* name_of(PoseOpKind kind) noexcept;

/// Builds a program in fixed memory, without allocation. Operations beyond kMostPoseOps are dropped but counted, and
/// `is_complete` returns false.
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
  /// in   threshold  in (0, 1]: smaller sums of weights are filled up with the rest pose, larger sums are normalised
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
