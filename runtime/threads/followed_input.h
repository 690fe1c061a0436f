// SPDX-License-Identifier: MIT
#pragma once
#include <memory_resource>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/plan/compile_plan.h"
#include "runtime/plan/frame_input.h"
#include "runtime/threads/follow_place.h"

namespace sinew {

/// Room for the overrides and procedures of an input whose places follow other characters.
/// owns  lists with the room that the plan declares, from `memory`
class FollowedInput {
 public:
  FollowedInput(const Plan& plan, std::pmr::memory_resource& memory);

  /// Copies the lists of an input, and lets the input refer to the copies.
  /// in   input  that InputCopy::check_room accepts.     cost O(its overrides and procedures), no allocation
  void copy_lists(FrameInput& input) noexcept;
  /// Places an override or the matrix of a procedure. copy_lists was called before, and the input has its final root.
  /// in   world  world matrix of the leader's joint
  /// err  index_out_of_range (the input has no such entry), unsupported (an override in local space), rank_deficient
  ///      (the follower's root has no inverse)
  ErrorCode place(const FrameInput& input, const FollowPlace& place, const Affine& world) noexcept;

 private:
  std::pmr::vector<JointOverrides> overrides_;
  std::pmr::vector<JointOverride> joints_;
  std::pmr::vector<PoseProcedure> procedures_;
};

}  // namespace sinew
