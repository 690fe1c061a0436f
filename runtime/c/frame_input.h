// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/c/frame.h"
#include "runtime/c/handles.h"
#include "runtime/plan/frame_input.h"

namespace sinew::c {

/// The input of a C caller as the runtime takes it.
/// in   given  null = the rest pose;   room[plan.input_room()]  for the layers
/// out  input  views of `room` and of the caller's weights
/// err  SINEW_WRONG_STRUCT_SIZE, SINEW_NULL_ARGUMENT, SINEW_SIZE_MISMATCH (more layers or weights than room),
///      SINEW_UNSUPPORTED (unknown kind; interpolation that the plan has no room for)
sinew_error read_input(const sinew_frame_input* given, const sinew_plan& plan, std::span<ClipLayer> room,
                       FrameInput& input) noexcept;

/// Layers of a C caller.    err  SINEW_NULL_ARGUMENT, SINEW_SIZE_MISMATCH (more than room), SINEW_UNSUPPORTED (kind)
sinew_error read_layers(const sinew_layer* given, std::size_t count, std::span<ClipLayer> room,
                        std::span<const ClipLayer>& layers) noexcept;

/// The other way: an input of the runtime for a C caller.
/// in   room[plan.input_room()]  for the layers
/// out  out  views of `room` and of what `input` views
sinew_error write_input(const FrameInput& input, std::span<sinew_layer> room, sinew_frame_input* out) noexcept;

}  // namespace sinew::c
