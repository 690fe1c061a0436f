// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/frame.h"

#ifdef __cplusplus
extern "C" {
#endif

// Frames in two halves. The first half makes the pose. The caller then reads it and writes into it: bodies of a physics
// engine, inverse kinematics against the world. The second half runs all stages after the pose. Frames of other
// characters may run between the halves, on any threads. Plans allow this with SINEW_NEED_CUT.

/// The pose of a frame that has run to its cut, in memory of the frame.
typedef struct sinew_cut_pose {
  size_t struct_size;
  sinew_pose local;     ///< may be written
  sinew_affines model;  ///< world matrices of that pose; empty if the plan makes none
} sinew_cut_pose;

/// Runs the first half. Do not read the frame's result until the second half has run.
/// in   input  as for sinew_run;   ops  operations of its program that run in the first half: at least 1,
///      SINEW_MOST_OPS = all. The others run in the second half, on the topmost pose as the caller left it. Layers run
///      in the first half
/// out  pose   valid until sinew_run_from_cut, or the next sinew_run, which drops the cut
/// err  those of sinew_run, and SINEW_NOT_IN_NEEDS (no cut), SINEW_UNSUPPORTED (the input is asleep, or 0 operations)
/// cost of the stages up to the world matrices; no allocation. The pose is computed in each such frame, even if the
///      input is unchanged
SINEW_API sinew_error sinew_run_to_cut(sinew_frame* frame, const sinew_frame_input* input, size_t ops,
                                       sinew_cut_pose* pose);

/// Runs the second half. The result has the bits that one run with the written pose would have.
/// in   input  the input that sinew_run_to_cut got
/// err  those of sinew_run; SINEW_NO_CUT if sinew_run_to_cut was not called before; SINEW_NOT_FINITE if the caller
///      wrote NaN or infinity into the pose. After an error the frame waits at its cut, so the call can be made again.
SINEW_API sinew_error sinew_run_from_cut(sinew_frame* frame, const sinew_frame_input* input);

#ifdef __cplusplus
}
#endif
