// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/c_geometry/sinew_geometry.h"
#include "tests/c/engine.h"

// A small engine in C that plays a geometry cache.

#ifdef __cplusplus
extern "C" {
#endif

/// A file in memory, and the reads that the engine has been asked for.
typedef struct engine_file {
  const unsigned char* bytes;
  size_t byte_count;
  size_t reads;
  int later;  ///< 1 = reads stay pending until engine_deliver()
  sinew_frame_read* waiting[64];
  size_t waiting_count;
} engine_file;
sinew_frame_reader engine_file_reader(engine_file* file);
/// Finishes all pending reads.
void engine_deliver(engine_file* file);

/// A character that shows only a geometry cache.
typedef struct engine_cloth {
  sinew_geometry_cache* cache;
  sinew_scene* scene;
  sinew_geometry_player* player;
  sinew_plan* plan;
  sinew_frame* frame;
} engine_cloth;
/// in   streams  1: only the head is opened, frames come through the reader
sinew_error engine_cloth_create(engine_file* file, int streams, engine_cloth* out);
void engine_cloth_destroy(engine_cloth* cloth);
/// Runs a frame in which all instances play.
sinew_error engine_cloth_run(engine_cloth* cloth, double time_s, float weight);

#ifdef __cplusplus
}
#endif
