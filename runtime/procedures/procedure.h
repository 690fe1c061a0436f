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

/// Solvers as procedures of pose programs. The share of the operation multiplies the weight of the goal. If the solver
/// refuses a goal, the pose is unchanged, and `result.error` says why.
/// Each struct and all memory that its goal refers to must stay in place and unchanged until the frame is done. If
/// several frames are in flight, each needs its own struct.

struct TwoBoneIk {
  TwoBoneGoal goal;
  IkResult result;  ///< of the last run; unchanged by frames that reuse their pose
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

/// Several procedures that run as one, in this order: for example two feet and a look-at of one character.
struct ProcedureList {
  std::span<const PoseProcedure> procedures;
};

/// out  version  hash of the goal, never 0. Frames with an unchanged goal and pose run nothing. The version of a list
///      is 0 if one of its procedures has version 0.
/// cost O(size of the goal), no allocation; call it again for each frame
SINEW_API PoseProcedure as_procedure(TwoBoneIk& ik) noexcept;
SINEW_API PoseProcedure as_procedure(AimIk& ik) noexcept;
SINEW_API PoseProcedure as_procedure(ChainIk& ik) noexcept;
SINEW_API PoseProcedure as_procedure(ProcedureList& list) noexcept;

}  // namespace sinew
