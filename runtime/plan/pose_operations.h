// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

#include "runtime/plan/compiled_plan.h"
#include "runtime/pose_program/run_pose_program.h"

namespace sinew {

/// The tables that pose operations of this plan read, except the rest pose, which is in the frame's memory.
/// out  views of the plan
PoseProgramAssets pose_assets(const CompiledPlan& plan) noexcept;

/// The room for pose operations: those that a frame's layers are turned into, and those of its program.
PoseProgramRoom pose_room(const CompiledPlan& plan) noexcept;

/// Entries of all lists of PoseProgramInputs that have a version.
constexpr std::size_t most_versions(const PoseProgramRoom& room) noexcept {
  return std::size_t{room.externals} + room.overrides + room.procedures + room.masks;
}

/// The lengths of all tables that programs of a plan may index, and the number of poses that the stack has room for.
PoseProgramLimits program_limits(const CompiledPlan& plan, const PoseProgramInputs& inputs) noexcept;

}  // namespace sinew
