// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/sinew.h"

// A small engine in C. The file engine.c is compiled as C (C11). The C++ tests compare its results with those of the
// C++ interface.

#ifdef __cplusplus
extern "C" {
#endif

/// A growing array of floats. All zero = empty.
typedef struct engine_numbers {
  float* values;
  size_t count, capacity;
} engine_numbers;
void engine_free(engine_numbers* numbers);
void engine_add(engine_numbers* to, const void* values, size_t count);  ///< appends `count` floats

/// Reads every number of a result, in the order of the C header.
sinew_error engine_read(const sinew_result* result, size_t skin_count, engine_numbers* out);

/// Compiles a plan, runs one frame, reads it, and frees everything.
sinew_error engine_play(const sinew_scene* scene, const sinew_needs* needs, const sinew_frame_input* input,
                        const sinew_allocator* allocator, engine_numbers* out);

/// Same, in a memory block of the engine between guard bytes. Returns SINEW_OVERLAPPING_BUFFERS if the guards were
/// overwritten.
sinew_error engine_play_in_block(const sinew_scene* scene, const sinew_needs* needs, const sinew_frame_input* input,
                                 engine_numbers* out);

/// State of an allocator that counts its calls and bytes; it is the allocator's `context`.
typedef struct engine_memory {
  size_t allocations, bytes_in_use, most_bytes;
  size_t refuse_after;  ///< number of allocations that succeed; later ones fail
} engine_memory;
sinew_allocator engine_allocator(engine_memory* memory);

/// An executor that runs all indices in sequence, the last one first.
typedef struct engine_executor_log {
  size_t calls, indices;
} engine_executor_log;
sinew_executor engine_executor(engine_executor_log* log);

/// Plays a clip with events at the given times in steps of dt. Returns how many events were crossed and stores the
/// first `capacity` of them.
size_t engine_events(double duration_s, uint32_t mode, double dt_s, int steps, const double* times_s, size_t count,
                     uint32_t* events, size_t capacity, double* end_s);

#ifdef __cplusplus
}
#endif
