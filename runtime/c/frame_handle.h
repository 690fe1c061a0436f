// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/c/frame.h"
#include "runtime/c/frame_input.h"
#include "runtime/plan/frame_buffer.h"

/// Lies at the beginning of its own memory; the room for one input and the frame buffer's block follow.
struct sinew_frame {
  const sinew_plan* plan;
  sinew_allocator allocator;
  sinew::c::InputRoom room;
  sinew::FrameBuffer buffer;
};
