// SPDX-License-Identifier: MIT
#pragma once
#include "tests/c/engine.h"

// An engine's work around frames: root motion, sockets, clip files, bounds, levels of detail, jobs of its own.

#ifdef __cplusplus
extern "C" {
#endif

/// Walks by root motion: `steps` steps of dt_s. Returns the place in the world, and the root of the last frame.
sinew_error engine_walk(const sinew_scene* scene, uint32_t clip, uint32_t joint, const sinew_root_parts* parts,
                        uint32_t mode, double dt_s, int steps, sinew_dual_quat* world, sinew_affine* root);

/// Runs one frame of a skeleton LOD. Reads the world matrices of all joints of the scene, each with
/// the offset. Then it reads the LOD's own numbers (left_out, worst_joint, measured_m as float, flags of kept joints).
sinew_error engine_play_lod(const sinew_scene* scene, double tolerance_m, const sinew_frame_input* input,
                            const sinew_affine* offset, engine_numbers* out);

/// Saves all clips and loads them from a copy of the bytes at another address.
sinew_error engine_save_and_load(sinew_scene* scene, size_t* byte_count);

/// Plays clip 0 in frames of dt_s by HeldInput (or InterpolatedInput) and reads the model matrices of every frame.
sinew_error engine_play_level(const sinew_scene* scene, uint32_t level, uint32_t phase, int interpolated, double dt_s,
                              uint64_t frames, engine_numbers* out);

/// Runs frames on a job system of the engine without threads: tasks run last to first, and every third frame is polled
/// instead. Reads the last frame of every character.
sinew_error engine_run_tasks(const sinew_scene* scene, const sinew_jobs_options* options,
                             const sinew_frame_input* inputs, size_t count, size_t skin_count, engine_numbers* out);

#ifdef __cplusplus
}
#endif
