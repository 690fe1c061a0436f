// SPDX-License-Identifier: MIT
#include "tests/c/engine_world.h"

#include <stdlib.h>
#include <string.h>

sinew_error engine_walk(const sinew_scene* scene, uint32_t clip, uint32_t joint, const sinew_root_parts* parts,
                        uint32_t mode, double dt_s, int steps, sinew_dual_quat* world, sinew_affine* root) {
  sinew_clock clock;
  sinew_error error = sinew_clock_init(&clock, sinew_clip_duration_s(scene, clip), mode, 1.0);
  *world = sinew_dual_quat_identity();
  for (int i = 0; i < steps && error == SINEW_OK; ++i) {
    sinew_step step;
    sinew_dual_quat motion;
    error = sinew_clock_advance(&clock, dt_s, &step);
    if (error == SINEW_OK) error = sinew_root_motion(scene, clip, joint, parts, &step, &motion);
    if (error == SINEW_OK) *world = sinew_dual_quat_product(world, &motion);
  }
  if (error != SINEW_OK) return error;
  sinew_dual_quat place;
  error = sinew_root_place(scene, clip, joint, parts, sinew_clock_time_s(&clock), &place);
  if (error != SINEW_OK) return error;
  const sinew_dual_quat back = sinew_dual_quat_inverse(&place);
  const sinew_dual_quat together = sinew_dual_quat_product(world, &back);
  *root = sinew_dual_quat_matrix(&together);
  return SINEW_OK;
}

static sinew_error read_sockets(const sinew_scene* scene, const sinew_plan* plan, const sinew_result* result,
                                const sinew_affine* offset, engine_numbers* out) {
  for (uint32_t joint = 0; joint < sinew_joint_count(scene); ++joint) {
    sinew_affine socket;
    const sinew_error error = sinew_world_of(plan, result, joint, offset, &socket);
    if (error != SINEW_OK) return error;
    engine_add(out, socket.row, 12);
  }
  return SINEW_OK;
}

sinew_error engine_play_lod(const sinew_scene* scene, double tolerance_m, const sinew_frame_input* input,
                            const sinew_affine* offset, engine_numbers* out) {
  sinew_skeleton_lod* lod = NULL;
  sinew_plan* plan = NULL;
  sinew_frame* frame = NULL;
  sinew_skeleton_lod_info info = {.struct_size = sizeof(info)};
  sinew_needs needs = sinew_default_needs();
  sinew_error error = sinew_skeleton_lod_create(scene, tolerance_m, NULL, 0, NULL, &lod);
  needs.skeleton_lod = lod;
  if (error == SINEW_OK) error = sinew_plan_create(scene, &needs, &plan);
  if (error == SINEW_OK) error = sinew_frame_create(plan, NULL, &frame);
  sinew_frame_prefetch(frame);
  sinew_frame_write_past_caches(frame, 1);
  if (error == SINEW_OK) error = sinew_run(frame, input);
  if (error == SINEW_OK) error = read_sockets(scene, plan, sinew_frame_result(frame), offset, out);
  if (error == SINEW_OK) error = sinew_get_skeleton_lod(lod, &info);
  if (error == SINEW_OK) {
    const float of_lod[] = {(float)info.left_out, (float)info.worst_joint, (float)info.measured_m};
    engine_add(out, of_lod, 3);
    for (size_t j = 0; j < info.kept.count; ++j) {
      const float kept = info.kept.data[j];
      engine_add(out, &kept, 1);
    }
  }
  sinew_frame_destroy(frame);
  sinew_plan_destroy(plan);
  sinew_skeleton_lod_destroy(lod);
  return error;
}

sinew_error engine_save_and_load(sinew_scene* scene, size_t* byte_count) {
  sinew_clip_block* block = NULL;
  sinew_error error = sinew_clips_save(scene, 0, sinew_clip_count(scene), &block);
  if (error != SINEW_OK) return error;
  const sinew_flags bytes = sinew_clip_block_bytes(block);
  *byte_count = bytes.count;
  unsigned char* file = malloc(bytes.count + 1);
  if (file == NULL) abort();
  memcpy(file + 1, bytes.data, bytes.count);
  sinew_clip_block_destroy(block);
  error = sinew_looks_like_clips(file + 1, *byte_count) ? SINEW_OK : SINEW_UNSUPPORTED;
  if (error == SINEW_OK) error = sinew_clips_load(scene, 0, file + 1, *byte_count, NULL);
  free(file);
  return error;
}

/// The inputs of a character that is not evaluated in every frame.
typedef struct level_player {
  sinew_held_input* held;
  sinew_interpolated_input* interpolated;
} level_player;

static sinew_error next_input(level_player* player, const sinew_frame_input* now, double dt_s, uint32_t level,
                              uint64_t frame, uint32_t phase, sinew_frame_input* input) {
  if (player->held != NULL) return sinew_held_input_next(player->held, now, level, frame, phase, input);
  sinew_layer ahead = now->layers[0];
  ahead.time_s = dt_s * (double)(frame + sinew_frames_to_update(level, frame, phase));
  return sinew_interpolated_input_next(player->interpolated, now, &ahead, 1, level, frame, phase, input);
}

static sinew_error play_frames(level_player* player, sinew_frame* frame, uint32_t level, uint32_t phase, double dt_s,
                               uint64_t frames, engine_numbers* out) {
  for (uint64_t number = 0; number < frames; ++number) {
    const sinew_layer layer = {dt_s * (double)number, 0, SINEW_NONE, 1.0f, SINEW_LAYER_BLEND};
    sinew_frame_input now = sinew_default_input();
    now.layers = &layer;
    now.layer_count = 1;
    now.root.row[1][3] = 0.25f * (float)number;
    sinew_frame_input input = {.struct_size = sizeof(input)};
    sinew_error error = next_input(player, &now, dt_s, level, number, phase, &input);
    if (error == SINEW_OK) error = sinew_run(frame, &input);
    sinew_result_info info = {.struct_size = sizeof(info)};
    if (error == SINEW_OK) error = sinew_get_result(sinew_frame_result(frame), &info);
    if (error != SINEW_OK) return error;
    engine_add(out, info.model.data, 12 * info.model.count);
  }
  return SINEW_OK;
}

sinew_error engine_play_level(const sinew_scene* scene, uint32_t level, uint32_t phase, int interpolated, double dt_s,
                              uint64_t frames, engine_numbers* out) {
  level_player player = {NULL, NULL};
  sinew_plan* plan = NULL;
  sinew_frame* frame = NULL;
  sinew_needs needs = sinew_default_needs();
  if (interpolated) needs.flags |= SINEW_NEED_BETWEEN_UPDATES;
  sinew_error error = sinew_plan_create(scene, &needs, &plan);
  if (error == SINEW_OK) error = sinew_frame_create(plan, NULL, &frame);
  if (error == SINEW_OK)
    error = interpolated ? sinew_interpolated_input_create(plan, &player.interpolated)
                         : sinew_held_input_create(plan, &player.held);
  if (error == SINEW_OK) error = play_frames(&player, frame, level, phase, dt_s, frames, out);
  sinew_held_input_destroy(player.held);
  sinew_interpolated_input_destroy(player.interpolated);
  sinew_frame_destroy(frame);
  sinew_plan_destroy(plan);
  return error;
}

static void run_frame(sinew_jobs* jobs, int poll) {
  enum { most_tasks = 64 };
  sinew_task tasks[most_tasks];
  size_t taken = 0;
  if (poll) {
    if (!sinew_jobs_poll(jobs)) abort();
    return;
  }
  while (taken < most_tasks && sinew_jobs_take_task(jobs, &tasks[taken])) ++taken;
  while (taken-- > 0) sinew_task_run(&tasks[taken]);
}

sinew_error engine_run_tasks(const sinew_scene* scene, const sinew_jobs_options* options,
                             const sinew_frame_input* inputs, size_t count, size_t skin_count, engine_numbers* out) {
  sinew_plan* plan = NULL;
  sinew_jobs* jobs = NULL;
  sinew_error error = sinew_plan_create(scene, NULL, &plan);
  if (error == SINEW_OK) error = sinew_jobs_create(options, &jobs);
  uint32_t character = 0;
  for (size_t c = 0; c < count && error == SINEW_OK; ++c) error = sinew_jobs_add_character(jobs, plan, &character);
  for (int frame = 0; frame < 3 && error == SINEW_OK; ++frame) {
    uint64_t ticket = 0;
    error = sinew_jobs_submit(jobs, inputs, count, &ticket);
    if (error != SINEW_OK) break;
    run_frame(jobs, frame == 2);
    error = sinew_jobs_done(jobs, ticket) ? sinew_jobs_last_error(jobs) : SINEW_BUSY;
    for (uint32_t c = 0; c < count; ++c) (void)sinew_jobs_latest(jobs, c);
  }
  for (uint32_t c = 0; c < count && error == SINEW_OK; ++c)
    error = engine_read(sinew_jobs_latest(jobs, c), skin_count, out);
  sinew_jobs_destroy(jobs);
  sinew_plan_destroy(plan);
  return error;
}
