// SPDX-License-Identifier: MIT
#pragma once
#include "tests/c/engine.h"

// What an engine does with clips that characters share: libraries, mirroring and retargeting.

#ifdef __cplusplus
extern "C" {
#endif

/// Plans a scene with the clips of a library, runs one frame, and reads it. The library is destroyed before the frame
/// runs.
sinew_error engine_play_from_library(const sinew_scene* scene, sinew_library* library, const sinew_needs* needs,
                                     const sinew_frame_input* input, engine_numbers* out);

/// Plays clip 0 mirrored by a frame, and mirrors its pose: reads the model matrices of both.
sinew_error engine_mirror(const sinew_scene* scene, double time_s, engine_numbers* by_frame, engine_numbers* by_pose);

/// Takes clip 0 of the source at a time to the target: reads the model matrices of the target. With `held` feet are
/// held.
sinew_error engine_retarget(const sinew_scene* source, const sinew_scene* target, double time_s, int held,
                            engine_numbers* out);

/// Every call with poses that cannot be: too few joints, not aligned, null. Answers how many were not refused.
int engine_bad_poses(const sinew_scene* scene);

#ifdef __cplusplus
}
#endif
