// SPDX-License-Identifier: MIT
#include "tests/c/engine_clips.h"

#include <stdlib.h>

sinew_error engine_play_from_library(const sinew_scene* scene, sinew_library* library, const sinew_needs* needs,
                                     const sinew_frame_input* input, engine_numbers* out) {
  sinew_plan* plan = NULL;
  sinew_frame* frame = NULL;
  sinew_error error = sinew_plan_create_from_library(scene, library, needs, NULL, &plan);
  sinew_library_destroy(library);
  if (error == SINEW_OK) error = sinew_frame_create(plan, NULL, &frame);
  if (error == SINEW_OK) error = sinew_run(frame, input);
  if (error == SINEW_OK) error = engine_read(sinew_frame_result(frame), sinew_skin_count(scene), out);
  sinew_frame_destroy(frame);
  sinew_plan_destroy(plan);
  return error;
}

static sinew_pose pose_of(const sinew_scene* scene) {
  const size_t joints = sinew_joint_count(scene);
  const sinew_pose pose = {aligned_alloc(SINEW_POSE_ALIGNMENT, sinew_pose_floats(joints) * sizeof(float)), joints};
  if (pose.planes == NULL) abort();
  return pose;
}

static sinew_error read_model(const sinew_scene* scene, const sinew_pose* pose, engine_numbers* out) {
  sinew_affine* model = malloc(pose->joint_count * sizeof(sinew_affine));
  if (model == NULL) abort();
  const sinew_error error = sinew_pose_to_model(scene, pose, NULL, model, pose->joint_count);
  if (error == SINEW_OK) engine_add(out, model, 12 * pose->joint_count);
  free(model);
  return error;
}

static sinew_error mirror_by_pose(const sinew_scene* scene, const sinew_mirror* mirror, double time_s,
                                  engine_numbers* out) {
  const sinew_pose pose = pose_of(scene), mirrored = pose_of(scene);
  sinew_error error = sinew_pose_sample(scene, 0, time_s, &pose);
  if (error == SINEW_OK) error = sinew_mirror_pose(mirror, &pose, &mirrored);
  if (error == SINEW_OK) error = read_model(scene, &mirrored, out);
  free(pose.planes);
  free(mirrored.planes);
  return error;
}

sinew_error engine_mirror(const sinew_scene* scene, double time_s, engine_numbers* by_frame, engine_numbers* by_pose) {
  sinew_mirror* mirror = NULL;
  sinew_error error = sinew_mirror_create(scene, &mirror);
  if (error != SINEW_OK) return error;
  sinew_needs needs = sinew_default_needs();
  needs.flags = SINEW_NEED_JOINTS;
  needs.mirror = mirror;
  const sinew_layer layer = {time_s, 0, SINEW_NONE, 1.0f, SINEW_LAYER_BLEND | SINEW_LAYER_MIRRORED};
  sinew_frame_input input = sinew_default_input();
  input.layers = &layer;
  input.layer_count = 1;
  sinew_plan* plan = NULL;
  sinew_frame* frame = NULL;
  error = mirror_by_pose(scene, mirror, time_s, by_pose);
  if (error == SINEW_OK) error = sinew_plan_create(scene, &needs, &plan);
  sinew_mirror_destroy(mirror);
  if (error == SINEW_OK) error = sinew_frame_create(plan, NULL, &frame);
  if (error == SINEW_OK) error = sinew_run(frame, &input);
  sinew_result_info info = {.struct_size = sizeof(info)};
  if (error == SINEW_OK) error = sinew_get_result(sinew_frame_result(frame), &info);
  if (error == SINEW_OK) engine_add(by_frame, info.model.data, 12 * info.model.count);
  sinew_frame_destroy(frame);
  sinew_plan_destroy(plan);
  return error;
}

sinew_error engine_retarget(const sinew_scene* source, const sinew_scene* target, double time_s, int held,
                            engine_numbers* out) {
  sinew_skeleton_map* map = NULL;
  sinew_error error = sinew_skeleton_map_create(source, target, NULL, &map);
  if (error != SINEW_OK) return error;
  const sinew_pose pose = pose_of(source), scratch = pose_of(source), retargeted = pose_of(target);
  float ground = 0.0f;
  error = sinew_pose_sample(source, 0, time_s, &pose);
  if (error == SINEW_OK) error = sinew_retarget_pose(map, &pose, &scratch, &retargeted);
  if (error == SINEW_OK && held) error = sinew_find_ground(map, 0, &ground);
  if (error == SINEW_OK && held) error = sinew_hold_feet(map, ground, &pose, &retargeted);
  if (error == SINEW_OK) error = read_model(target, &retargeted, out);
  free(pose.planes);
  free(scratch.planes);
  free(retargeted.planes);
  sinew_skeleton_map_destroy(map);
  return error;
}

int engine_bad_poses(const sinew_scene* scene) {
  const sinew_pose good = pose_of(scene);
  const sinew_pose bad[] = {
      {good.planes, good.joint_count - 1}, {good.planes + 1, good.joint_count}, {NULL, good.joint_count}};
  sinew_mirror* mirror = NULL;
  sinew_skeleton_map* map = NULL;
  int accepted = 0;
  sinew_affine model;
  if (sinew_mirror_create(scene, &mirror) != SINEW_OK) abort();
  if (sinew_skeleton_map_create(scene, scene, NULL, &map) != SINEW_OK) abort();
  for (size_t i = 0; i < sizeof(bad) / sizeof(bad[0]); ++i) {
    const sinew_error expected = bad[i].planes == NULL ? SINEW_NULL_ARGUMENT : SINEW_SIZE_MISMATCH;
    accepted += sinew_pose_rest(scene, &bad[i]) != expected;
    accepted += sinew_pose_sample(scene, 0, 0.0, &bad[i]) != expected;
    accepted += sinew_pose_to_model(scene, &bad[i], NULL, &model, 1) != expected;
    accepted += sinew_mirror_pose(mirror, &bad[i], &good) != expected;
    accepted += sinew_mirror_pose(mirror, &good, &bad[i]) != expected;
    accepted += sinew_retarget_pose(map, &bad[i], &good, &good) != expected;
    accepted += sinew_retarget_pose(map, &good, &good, &bad[i]) != expected;
    accepted += sinew_hold_feet(map, 0.0f, &bad[i], &good) != expected;
    accepted += sinew_hold_feet(map, 0.0f, &good, &bad[i]) != expected;
  }
  sinew_mirror_destroy(mirror);
  sinew_skeleton_map_destroy(map);
  free(good.planes);
  return accepted;
}
