// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/c/glue/fields.h"
#include "runtime/c/pose_program.h"
#include "runtime/pose_program/pose_program.h"

namespace sinew::c {

/// The room for programs on both sides.
inline constexpr auto kProgramRoom =
    fields(field<&sinew_program_room::ops, &PoseProgramRoom::ops>(),
           field<&sinew_program_room::slots, &PoseProgramRoom::slots>(),
           field<&sinew_program_room::externals, &PoseProgramRoom::externals>(),
           field<&sinew_program_room::overrides, &PoseProgramRoom::overrides>(),
           field<&sinew_program_room::procedures, &PoseProgramRoom::procedures>(),
           field<&sinew_program_room::masks, &PoseProgramRoom::masks>(),
           field<&sinew_program_room::overridden_joints, &PoseProgramRoom::overridden_joints>(),
           field<&sinew_program_room::overlays_in_model_space, &PoseProgramRoom::overlays_in_model_space>(),
           field<&sinew_program_room::kept, &PoseProgramRoom::kept>());

}  // namespace sinew::c
