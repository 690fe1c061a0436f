// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/c/pose_program.h"
#include "runtime/pose_program/pose_program.h"

namespace sinew::c {

/// The room of a C caller as the runtime takes it.
/// in   given  null = no programs
/// err  SINEW_WRONG_STRUCT_SIZE, SINEW_UNSUPPORTED (more than any program can use)
sinew_error read_program_room(const sinew_program_room* given, PoseProgramRoom& room) noexcept;

}  // namespace sinew::c
