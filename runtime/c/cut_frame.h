// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/frame.h"

#ifdef __cplusplus
extern "C" {
#endif

// Frames in two halves. The first makes the pose; then the caller looks at it and writes into it: bodies of a physics
// engine, inverse kinematics against the world. The second makes everything that follows a pose. Frames of other
// characters may run between the halves, on any threads. Plans have cuts by SINEW_NEED_CUT.

/// The pose of a frame that has run to its cut, in memory of the frame.
typedef struct sinew_cut_pose {
  size_t struct_size;
  sinew_pose local;     ///< may be written
  sinew_affines model;  ///< world matrices of that pose; empty where the plan makes none
} sinew_cut_pose;

/// Runs the first half. The frame's result is not to be read until the second half has run.
/// in   input  as for sinew_run;   ops  [1, ...] operations of its program that run before the cut, SINEW_MOST_OPS =
///             all. The others run after it, on the topmost pose as the caller left it. Layers run before it as a whole
/// out  pose   valid until sinew_run_from_cut, or the next sinew_run, which drops the cut
/// err  those of sinew_run, and SINEW_NOT_IN_NEEDS (no cut), SINEW_UNSUPPORTED (the input is asleep, or 0 operations)
/// cost of the stages up to the world matrices; no allocation. Poses are made anew in each such frame
SINEW_API sinew_error sinew_run_to_cut(sinew_frame* frame, const sinew_frame_input* input, size_t ops,
                                       sinew_cut_pose* pose);

/// Runs the second half. The result has the bits that one run with the written pose would have.
/// in   input  the input that sinew_run_to_cut got
/// err  those of sinew_run; SINEW_NO_CUT where sinew_run_to_cut was not called before; SINEW_NOT_FINITE where the caller
///      wrote NaN or infinity into the pose. After an error the frame waits at its cut, so the call can be made again.
SINEW_API sinew_error sinew_run_from_cut(sinew_frame* frame, const sinew_frame_input* input);

#ifdef __cplusplus
}
#endif
