// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>

#include "runtime/base/api.h"
#include "runtime/pose_program/program_inputs.h"
#include "runtime/procedures/aim.h"
#include "runtime/procedures/chain_ik.h"
#include "runtime/procedures/two_bone_ik.h"

namespace sinew {

/// Solvers as operations of pose programs: for plans, the job thread and crowds. The share of the operation multiplies
/// the weight of the goal. A goal that the solver refuses leaves the pose alone, and `result.error` says why.
/// Each struct, and all that its goal refers to, stays in place and unchanged until the frame is done. A job thread
/// that has several frames in flight needs one struct for each.

struct TwoBoneIk {
  TwoBoneGoal goal;
  IkResult result;  ///< of the last run; a frame that reuses its pose does not run
};

struct AimIk {
  AimGoal goal;
  IkResult result;
};

struct ChainIk {
  ChainGoal goal;
  std::span<std::byte> memory;  ///< as ChainIkJob::memory, for the skeleton of the poses
  IkResult result;
};

/// Several procedures as one, in this order: two feet and a look-at of one character.
struct ProcedureList {
  std::span<const PoseProcedure> procedures;
};

/// out  version  hash of the goal, so a goal that has not changed runs nothing again; never 0. That of a list is 0 if
///               one of its procedures promises nothing.
/// cost O(size of the goal), no allocation; make it anew for each frame
SINEW_API PoseProcedure as_procedure(TwoBoneIk& ik) noexcept;
SINEW_API PoseProcedure as_procedure(AimIk& ik) noexcept;
SINEW_API PoseProcedure as_procedure(ChainIk& ik) noexcept;
SINEW_API PoseProcedure as_procedure(ProcedureList& list) noexcept;

}  // namespace sinew
