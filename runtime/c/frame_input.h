// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/c/frame.h"
#include "runtime/c/glue/not_read.h"
#include "runtime/c/handles.h"
#include "runtime/c/input_room.h"
#include "runtime/plan/frame_input.h"

namespace sinew::c {

/// The input of a C caller as the runtime takes it.
/// in   given  null = the rest pose
/// out  input  views of `room` and of the caller's memory
/// err  SINEW_WRONG_STRUCT_SIZE, SINEW_NULL_ARGUMENT, SINEW_TOO_MANY_LAYERS, SINEW_SIZE_MISMATCH (more weights or
///      instances that play than room), SINEW_UNSUPPORTED (unknown kind), SINEW_NOT_IN_NEEDS (interpolation), those of
///      read_program
NotRead read_input(const sinew_frame_input* given, const sinew_plan& plan, const InputRoom& room,
                   FrameInput& input) noexcept;

/// Layers of a C caller that are no part of an input.
/// in   list  its name, for refusals
/// err  SINEW_NULL_ARGUMENT, SINEW_TOO_MANY_LAYERS, SINEW_UNSUPPORTED (kind)
NotRead read_layers(const sinew_layer* given, std::size_t count, const char* list, std::span<ClipLayer> room,
                    std::span<const ClipLayer>& layers) noexcept;

/// The other way: an input of the runtime for a C caller.
/// out  out  views of `room` and of what `input` views
sinew_error write_input(const FrameInput& input, const InputRoomOfC& room, sinew_frame_input* out) noexcept;

}  // namespace sinew::c
