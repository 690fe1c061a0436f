// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/c/frame.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Frames of many characters, evaluated beside the caller's thread. One thread submits and reads.
typedef struct sinew_jobs sinew_jobs;

/// The engine's job system: calls body(body_context, i) once for every i in [0, count), on any threads, and returns
/// when all are done.
typedef struct sinew_executor {
  void* context;
  void (*run)(void* context, size_t count, void (*body)(void* body_context, size_t i), void* body_context);
} sinew_executor;

typedef struct sinew_jobs_options {
  size_t struct_size;
  sinew_executor executor;    ///< run null = oneTBB
  sinew_allocator allocator;  ///< of frame memory; allocate null = operator new
  size_t inline_below_bytes;  ///< a frame of all characters of less memory than this runs on the worker itself
  size_t part_bytes;          ///< consecutive characters that the executor is handed as one: at least so much memory
} sinew_jobs_options;
sinew_jobs_options sinew_default_jobs_options(void);

/// in   options  null = the defaults; copied, what its pointers name must outlive the jobs
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_OUT_OF_MEMORY
sinew_error sinew_jobs_create(const sinew_jobs_options* options, sinew_jobs** out);
void sinew_jobs_destroy(sinew_jobs* jobs);  ///< finishes the frame in flight

/// in   plan  must outlive the jobs. Waits for the frame in flight.
sinew_error sinew_jobs_add_character(sinew_jobs* jobs, const sinew_plan* plan, uint32_t* character);

/// Queues one frame: inputs[c] is what character c shows; copied.
/// out  ticket  names the frame: 1 for the first, rising by one; may be null
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_SIZE_MISMATCH (another number of characters, too many
/// layers), SINEW_BUSY
sinew_error sinew_jobs_submit(sinew_jobs* jobs, const sinew_frame_input* inputs, size_t input_count, uint64_t* ticket);
int sinew_jobs_done(const sinew_jobs* jobs, uint64_t ticket);
/// in   ticket  that was answered by submit
sinew_error sinew_jobs_wait(const sinew_jobs* jobs, uint64_t ticket);

/// Newest finished frame of a character, unchanged until asked for again; null before the first.
const sinew_result* sinew_jobs_latest(sinew_jobs* jobs, uint32_t character);
/// First error of the last finished frame. A character that failed keeps showing its last good frame.
sinew_error sinew_jobs_last_error(const sinew_jobs* jobs);

#ifdef __cplusplus
}
#endif
