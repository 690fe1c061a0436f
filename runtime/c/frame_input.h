// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/c/frame.h"
#include "runtime/c/handles.h"
#include "runtime/plan/frame_input.h"

namespace sinew::c {

/// The input of a C caller as the runtime takes it.
/// in   given  null = the rest pose;   room[plan.layer_room()]  for the layers
/// out  input  views of `room` and of the caller's weights
/// err  SINEW_WRONG_STRUCT_SIZE, SINEW_NULL_ARGUMENT, SINEW_SIZE_MISMATCH (more layers than room), SINEW_UNSUPPORTED
/// (unknown kind)
sinew_error read_input(const sinew_frame_input* given, const sinew_plan& plan, std::span<ClipLayer> room,
                       FrameInput& input) noexcept;

}  // namespace sinew::c
