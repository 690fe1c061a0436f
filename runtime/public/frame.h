// SPDX-License-Identifier: MIT
#pragma once
/// A frame of one character: FrameInput says which clips play at which times, run_plan evaluates them, and FrameResult
/// has joints, palettes and vertices. FrameBuffer is all memory of a character; frames allocate nothing.
///
///     sinew::FrameBuffer frame(plan);
///     const sinew::ClipLayer layers[] = {{.clip = 0, .time_s = clock.time_s()}};
///     if (run_plan(plan, {.layers = layers}, frame) != sinew::ErrorCode::ok) return;
///     for (const sinew::DeformedPrimitive& primitive : frame.result().primitives) upload(primitive);
#include "runtime/plan/frame_buffer.h"
#include "runtime/plan/frame_input.h"
#include "runtime/plan/frame_result.h"
#include "runtime/plan/run_plan.h"
#include "runtime/plan/vertex_source.h"
