// SPDX-License-Identifier: MIT
// The version of main.cpp in C (2011): read an asset file, plan, run frames into one block of memory, follow a clock.
#include <stdio.h>
#include <stdlib.h>

#include <sinew/sinew.h>
#include <sinew/sinew_assets.h>

static int fail(const char* what, sinew_error error) {
  fprintf(stderr, "%s: %s\n", what, sinew_describe(error));
  return 1;
}

/// Plays the first clip for one second, in steps of 0.25 s. Returns the number of errors.
static int play(const sinew_scene* scene, sinew_frame* frame) {
  sinew_clock clock;
  sinew_clock_init(&clock, sinew_clip_duration_s(scene, 0), SINEW_PLAY_CLAMP, 1.0);
  for (int step = 0; step <= 4; ++step) {
    const sinew_layer layer = {
        .time_s = sinew_clock_time_s(&clock), .clip = 0, .mask = SINEW_NONE, .weight = 1.0f, .kind = SINEW_LAYER_BLEND};
    sinew_frame_input input = sinew_default_input();
    if (sinew_clip_count(scene) > 0) {
      input.layers = &layer;
      input.layer_count = 1;
    }
    const sinew_error error = sinew_run(frame, &input);
    if (error != SINEW_OK) return fail("sinew_run", error);
    sinew_result_info result = {.struct_size = sizeof(result)};
    sinew_get_result(sinew_frame_result(frame), &result);
    for (uint32_t joint = 0; joint < 1 && joint < result.model.count; ++joint) {
      const sinew_affine* model = &result.model.data[joint];
      const sinew_string name = sinew_joint_name(scene, joint);
      printf("%.2f s: %.*s at %.3f %.3f %.3f m\n", layer.time_s, (int)name.length, name.data, (double)model->row[0][3],
             (double)model->row[1][3], (double)model->row[2][3]);
    }
    sinew_clock_advance(&clock, 0.25, NULL);
  }
  return 0;
}

/// Reads the scene of a file; frees the file's bytes.
static sinew_error read_scene(const char* path, sinew_scene** scene, sinew_messages** messages) {
  FILE* file = fopen(path, "rb");
  if (file == NULL) return SINEW_BAD_FILE;
  fseek(file, 0, SEEK_END);
  const long size = ftell(file);
  rewind(file);
  void* bytes = size > 0 ? malloc((size_t)size) : NULL;
  const int complete = bytes != NULL && fread(bytes, 1, (size_t)size, file) == (size_t)size;
  fclose(file);
  const sinew_error error = complete ? sinew_assets_read(bytes, (size_t)size, scene, messages) : SINEW_BAD_FILE;
  free(bytes);
  return error;
}

int main(int argc, char** argv) {
  if (argc != 2) {
    fprintf(stderr, "usage: link_from_c FILE.sinew\n");
    return 2;
  }
  if (sinew_version() != SINEW_VERSION) {
    fprintf(stderr, "the library is not that of the header\n");
    return 1;
  }
  sinew_scene* scene = NULL;
  sinew_messages* messages = NULL;
  sinew_error error = read_scene(argv[1], &scene, &messages);
  for (size_t i = 0; messages != NULL && i < sinew_message_count(messages); ++i)
    fprintf(stderr, "%s\n", sinew_message(messages, i));
  sinew_messages_destroy(messages);
  if (error != SINEW_OK) return fail(argv[1], error);

  sinew_plan* plan = NULL;
  error = sinew_plan_create(scene, NULL, &plan);
  if (error != SINEW_OK) return fail("sinew_plan_create", error);
  const size_t size =
      (sinew_plan_frame_bytes(plan) + SINEW_FRAME_ALIGNMENT - 1) / SINEW_FRAME_ALIGNMENT * SINEW_FRAME_ALIGNMENT;
  void* block = aligned_alloc(SINEW_FRAME_ALIGNMENT, size);  // from the engine's own memory
  sinew_frame* frame = NULL;
  error = block != NULL ? sinew_frame_create_in(plan, block, size, &frame) : SINEW_OUT_OF_MEMORY;
  const int failed = error == SINEW_OK ? play(scene, frame) : fail("sinew_frame_create_in", error);
  sinew_frame_destroy(frame);
  free(block);
  sinew_plan_destroy(plan);
  sinew_scene_destroy(scene);
  return failed;
}
