// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/c/frame.h"
#include "runtime/c/glue/not_read.h"
#include "runtime/c/input_room.h"
#include "runtime/plan/frame_input.h"

namespace sinew::c {

/// Converts the program of a C caller to that of the runtime. Operations, pages, planes, numbers and overridden joints
/// stay in the caller's memory.
/// in   given  converted to this library's version of the struct
/// out  input  its program and program_inputs: views of `room` and of the caller's memory
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_NOT_IN_NEEDS (a list is longer than the needs
///      declare), SINEW_SIZE_MISMATCH (a pose that is not aligned), SINEW_UNSUPPORTED (unknown space)
NotRead read_program(const sinew_frame_input& given, const PoseProgramRoom& needs, const InputRoom& room,
                     FrameInput& input) noexcept;

/// Converts a program of the runtime to one for a C caller. Its procedures are those that a C caller gave.
/// out  out  views of `room`, and of the memory that `input` refers to
void write_program(const FrameInput& input, const InputRoomOfC& room, sinew_frame_input& out) noexcept;

}  // namespace sinew::c
