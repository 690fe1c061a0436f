// SPDX-License-Identifier: MIT
#include "tests/c/engine_geometry.h"

#include <string.h>

static sinew_read_outcome read_file(void* context, uint64_t offset, void* into, size_t byte_count,
                                    sinew_frame_read* read) {
  engine_file* file = context;
  ++file->reads;
  if (offset > file->byte_count || byte_count > file->byte_count - offset) return SINEW_READ_FAILED;
  memcpy(into, file->bytes + offset, byte_count);
  if (!file->later) return SINEW_READ_DONE;
  if (file->waiting_count == sizeof(file->waiting) / sizeof(file->waiting[0])) return SINEW_READ_FAILED;
  file->waiting[file->waiting_count++] = read;
  return SINEW_READ_PENDING;
}

sinew_frame_reader engine_file_reader(engine_file* file) {
  const sinew_frame_reader reader = {read_file, file};
  return reader;
}

void engine_deliver(engine_file* file) {
  for (size_t i = 0; i < file->waiting_count; ++i) sinew_frame_read_finish(file->waiting[i], 1);
  file->waiting_count = 0;
}

sinew_error engine_cloth_create(engine_file* file, int streams, engine_cloth* out) {
  memset(out, 0, sizeof(*out));
  const size_t byte_count = streams ? (size_t)sinew_geometry_head_bytes(file->bytes, 40) : file->byte_count;
  const sinew_frame_reader reader = engine_file_reader(file);
  const int later = file->later;
  sinew_error error = sinew_geometry_open(file->bytes, byte_count, file->byte_count, &out->cache, NULL);
  file->later = 0;
  if (error == SINEW_OK) error = sinew_geometry_scene(out->cache, streams ? &reader : NULL, &out->scene);
  file->later = later;
  sinew_geometry_player_options options = sinew_default_geometry_player_options();
  options.window_frames = 4;
  if (streams) options.reader = reader;
  if (error == SINEW_OK) error = sinew_geometry_player_create(out->cache, out->scene, &options, &out->player, NULL);
  sinew_needs needs = sinew_default_needs();
  needs.flags |= SINEW_NEED_BOUNDS;
  needs.cached_instances = sinew_geometry_player_instances(out->player);
  if (error == SINEW_OK) error = sinew_plan_create(out->scene, &needs, &out->plan);
  if (error == SINEW_OK) error = sinew_frame_create(out->plan, NULL, &out->frame);
  return error;
}

void engine_cloth_destroy(engine_cloth* cloth) {
  sinew_frame_destroy(cloth->frame);
  sinew_plan_destroy(cloth->plan);
  sinew_geometry_player_destroy(cloth->player);
  sinew_scene_destroy(cloth->scene);
  sinew_geometry_close(cloth->cache);
  memset(cloth, 0, sizeof(*cloth));
}

sinew_error engine_cloth_run(engine_cloth* cloth, double time_s, float weight) {
  enum { most = 8 };
  sinew_geometry_input geometry[most];
  const size_t count = sinew_geometry_player_instances(cloth->player).count;
  if (count > most) return SINEW_SIZE_MISMATCH;
  for (size_t i = 0; i < count; ++i) {
    geometry[i].source = sinew_geometry_player_source(cloth->player);
    geometry[i].time_s = time_s;
    geometry[i].weight = weight;
  }
  sinew_frame_input input = sinew_default_input();
  input.geometry = geometry;
  input.geometry_count = count;
  return sinew_run(cloth->frame, &input);
}
