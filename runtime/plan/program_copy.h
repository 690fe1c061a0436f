// SPDX-License-Identifier: MIT
#pragma once
#include <memory_resource>
#include <span>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/plan/compile_plan.h"
#include "runtime/plan/frame_input.h"

namespace sinew {

/// A pose program with everything that its indices refer to, in memory of its own.
/// owns  copies of all lists, poses, joints and masks, with room for what the plan declares (Needs::in.program).
///       Procedures stay the caller's: their contexts must outlive the frame.
class SINEW_API ProgramCopy {
 public:
  ProgramCopy(const Plan& plan, std::pmr::memory_resource& memory);

  /// Checks that the program of an input fits into the room of the plan.
  /// err  not_in_needs (more of a list than the needs declare), size_mismatch (poses or masks of another size)
  ErrorCode check_room(const FrameInput& input) const noexcept;
  /// Copies the program of an input.
  /// in   input  checked by check_room.     cost O(its lists and poses), no allocation
  void assign(const FrameInput& input) noexcept;
  /// Lets `input` refer to the copied program; valid until the next program is assigned.
  void show(FrameInput& input) const noexcept;

 private:
  PoseProgramRoom room_;
  std::size_t joints_, weights_, properties_;
  std::pmr::vector<PoseOp> ops_;
  std::pmr::vector<const Clip*> pages_;
  std::pmr::vector<ExternalPose> externals_;
  std::pmr::vector<JointOverrides> overrides_;
  std::pmr::vector<PoseProcedure> procedures_;
  std::pmr::vector<PoseMask> masks_;
  std::pmr::vector<std::byte> poses_;  // poses of externals; aligned by hand, since planes need 64 bytes
  std::pmr::vector<float> external_numbers_, mask_weights_;  // weights and properties of externals; of all masks
  std::pmr::vector<JointOverride> joints_of_overrides_;
};

}  // namespace sinew
