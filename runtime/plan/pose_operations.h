// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

#include "runtime/plan/compiled_plan.h"
#include "runtime/pose_program/run_pose_program.h"

namespace sinew {

/// The tables that pose operations of this plan read, but for the rest pose, which lies in the frame's memory.
/// out  views of the plan
PoseProgramAssets pose_assets(const CompiledPlan& plan) noexcept;

/// Room for the operations that a frame's layers or its program become.
PoseProgramRoom pose_room(const CompiledPlan& plan) noexcept;

/// Entries of all lists of PoseProgramInputs that have a version.
constexpr std::size_t most_versions(const PoseProgramRoom& room) noexcept {
  return std::size_t{room.externals} + room.overrides + room.procedures + room.masks;
}

/// The tables that programs of a plan may name entries of, and the poses that there is room for.
PoseProgramLimits program_limits(const CompiledPlan& plan, const PoseProgramInputs& inputs) noexcept;

}  // namespace sinew
