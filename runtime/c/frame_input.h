// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/c/frame.h"
#include "runtime/c/glue/not_read.h"
#include "runtime/c/handles.h"
#include "runtime/c/input_room.h"
#include "runtime/plan/frame_input.h"

namespace sinew::c {

/// Converts the frame input of a C caller to that of the runtime.
/// in   given  null = the rest pose
/// out  input  views of `room` and of the caller's memory
/// err  SINEW_WRONG_STRUCT_SIZE, SINEW_NULL_ARGUMENT, SINEW_TOO_MANY_LAYERS, SINEW_SIZE_MISMATCH (more weights or
///      playing instances than there is room for), SINEW_UNSUPPORTED (unknown kind), SINEW_NOT_IN_NEEDS
///      (interpolation), those of read_program
NotRead read_input(const sinew_frame_input* given, const sinew_plan& plan, const InputRoom& room,
                   FrameInput& input) noexcept;

/// Converts layers of a C caller that do not belong to an input.
/// in   list  name of the list in refusals
/// err  SINEW_NULL_ARGUMENT, SINEW_TOO_MANY_LAYERS, SINEW_UNSUPPORTED (kind)
NotRead read_layers(const sinew_layer* given, std::size_t count, const char* list, std::span<ClipLayer> room,
                    std::span<const ClipLayer>& layers) noexcept;

/// Converts an input of the runtime to one for a C caller.
/// out  out  views of `room`, and of the memory that `input` refers to
sinew_error write_input(const FrameInput& input, const InputRoomOfC& room, sinew_frame_input* out) noexcept;

}  // namespace sinew::c
