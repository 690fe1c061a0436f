// SPDX-License-Identifier: MIT
#pragma once
#include "tests/c/engine.h"

// Clips that characters share, as an engine uses them in C: libraries, mirroring and retargeting.

#ifdef __cplusplus
extern "C" {
#endif

/// Compiles a plan of a scene and a clip library, runs one frame, and reads it. The library is destroyed before the
/// frame runs.
sinew_error engine_play_from_library(const sinew_scene* scene, sinew_library* library, const sinew_needs* needs,
                                     const sinew_frame_input* input, engine_numbers* out);

/// Plays clip 0 mirrored in two ways, by a mirrored layer and by mirroring the pose. Reads the model matrices of both.
sinew_error engine_mirror(const sinew_scene* scene, double time_s, engine_numbers* by_frame, engine_numbers* by_pose);

/// Retargets clip 0 of the source at a time. Reads the model matrices of the target. If `held` is not 0, feet are held.
sinew_error engine_retarget(const sinew_scene* source, const sinew_scene* target, double time_s, int held,
                            engine_numbers* out);

/// Makes every call with invalid poses: too few joints, misaligned, null. Returns the number of calls that were not
/// refused.
int engine_bad_poses(const sinew_scene* scene);

#ifdef __cplusplus
}
#endif
