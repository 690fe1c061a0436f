// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/sinew.h"

// An engine in small, written in C11: engine.c is compiled as such, and the C++ tests beside it compare what it reads
// with what the C++ interface gives.

#ifdef __cplusplus
extern "C" {
#endif

/// Numbers in a row; grows with realloc. All zero = empty.
typedef struct engine_numbers {
  float* values;
  size_t count, capacity;
} engine_numbers;
void engine_free(engine_numbers* numbers);
void engine_add(engine_numbers* to, const void* values, size_t count);  ///< floats

/// Everything that a result shows, in the order of the C header.
sinew_error engine_read(const sinew_result* result, size_t skin_count, engine_numbers* out);

/// Plans, runs one frame, reads it, and cleans up.
sinew_error engine_play(const sinew_scene* scene, const sinew_needs* needs, const sinew_frame_input* input,
                        const sinew_allocator* allocator, engine_numbers* out);

/// The same in a block of its own, in which nothing else is touched (checked with guards; SINEW_OVERLAPPING_BUFFERS if
/// so).
sinew_error engine_play_in_block(const sinew_scene* scene, const sinew_needs* needs, const sinew_frame_input* input,
                                 engine_numbers* out);

/// Counts and keeps account of sizes; `context` of the allocator is this.
typedef struct engine_memory {
  size_t allocations, bytes_in_use, most_bytes;
  size_t refuse_after;  ///< allocations that succeed
} engine_memory;
sinew_allocator engine_allocator(engine_memory* memory);

/// Runs one index after another, the last one first.
typedef struct engine_executor_log {
  size_t calls, indices;
} engine_executor_log;
sinew_executor engine_executor(engine_executor_log* log);

/// Plays a clip with events at the given times by steps of dt; answers how many were crossed, and the first `capacity`
/// of them.
size_t engine_events(double duration_s, uint32_t mode, double dt_s, int steps, const double* times_s, size_t count,
                     uint32_t* events, size_t capacity, double* end_s);

#ifdef __cplusplus
}
#endif
