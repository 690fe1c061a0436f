// SPDX-License-Identifier: MIT
#pragma once
#include <stddef.h>
#include <stdint.h>

#include "runtime/base/api.h"

// Rules of the whole C interface.
//
// Handles are opaque. The caller of sinew_X_create owns the handle and frees it with sinew_X_destroy, which accepts
// NULL too. Spans and strings are views into the handle that returned them. They live as long as that handle, or as the
// function says. No function keeps a pointer that it was given, unless it says so.
//
// Structs that may grow begin with struct_size, which the caller sets to sizeof. The library reads and writes no more
// than that. It is also the distance between elements of an array, so all elements must have the same struct_size. An
// older program runs with a newer library, where new fields take their defaults. A newer program runs with an older
// library as long as it leaves the new fields zero. For null pointers and invalid numbers, functions return an error
// code or an empty result.
//
// No exception leaves a function. Different handles may be used by different threads. Plans never change. Scenes change
// only by adding or replacing clips, which fails while they have plans. So any number of threads may read both.
// Right-handed, +Y up, metres, seconds, radians; matrices are three rows of four, column vectors, the translation last.

#ifdef __cplusplus
extern "C" {
#endif

#define SINEW_VERSION_MAJOR 0
#define SINEW_VERSION_MINOR 1
#define SINEW_VERSION_PATCH 0
#define SINEW_VERSION ((SINEW_VERSION_MAJOR << 16) | (SINEW_VERSION_MINOR << 8) | SINEW_VERSION_PATCH)

/// Version of the library that was linked, to be compared with SINEW_VERSION of the header.
SINEW_API uint32_t sinew_version(void);

#define SINEW_NONE 0xffffffffu  ///< "no index"

/// The numbers of error codes never change.
typedef enum sinew_error {
  SINEW_OK = 0,
  SINEW_SIZE_MISMATCH = 1,  ///< a buffer is too short, or two parallel buffers differ in length
  SINEW_OVERLAPPING_BUFFERS = 2,
  SINEW_INDEX_OUT_OF_RANGE = 3,
  SINEW_PARENTS_NOT_FIRST = 4,
  SINEW_TIMES_NOT_INCREASING = 5,
  SINEW_TOO_FEW_KEYS = 6,
  SINEW_NOT_FINITE = 7,
  SINEW_UNSUPPORTED = 8,  ///< the requested combination does not exist
  SINEW_COINCIDENT_POSES = 9,
  SINEW_RANK_DEFICIENT = 10,
  SINEW_BUSY = 11,             ///< a frame is already queued, or a scene has plans
  SINEW_NOT_NORMALISED = 12,   ///< a rotation is not unit, or the weights of a vertex do not sum to 1
  SINEW_NO_PLAN = 13,          ///< returned by no C function: plan handles always have a plan
  SINEW_WRONG_PLAN = 14,       ///< the frame was made for another plan
  SINEW_MOVED_FROM = 15,       ///< returned by no C function
  SINEW_TOO_MANY_LAYERS = 16,  ///< more layers than the plan's needs have room for
  SINEW_WRONG_PAGE = 17,       ///< a page is cut from a clip with other joints, weights or properties
  SINEW_NOT_IN_NEEDS = 18,     ///< the input uses a feature that the plan's needs do not declare
  SINEW_NEGATIVE_WEIGHT = 19,
  SINEW_NOT_A_FRACTION = 20,     ///< a number is outside [0, 1]
  SINEW_TWO_TIMES = 21,          ///< one vertex source is asked for two times in one frame
  SINEW_TOO_LARGE = 22,          ///< a finite number is so large that results could overflow
  SINEW_NO_CUT = 23,             ///< the second half of a frame was called without its first half
  SINEW_UNKNOWN_CHARACTER = 24,  ///< the jobs have no such character, or it was removed
  SINEW_FOLLOWS_ITSELF = 25,   ///< a character would follow itself, directly or through the characters that it follows
  SINEW_OUTSIDE_OF_CLIP = 26,  ///< a time is before the start or after the end of the clip
  SINEW_NULL_ARGUMENT = 100,   ///< a required pointer is null
  SINEW_WRONG_STRUCT_SIZE = 101,  ///< struct_size is below that of the first version; or above this library's, with
                                  ///< additional bytes that are not zero
  SINEW_OUT_OF_MEMORY = 102,
  SINEW_BAD_FILE = 103,  ///< the message says where and why
  SINEW_UNBOUND = 104    ///< clips move joints, weights or properties that do not exist; the messages name them
} sinew_error;

/// One sentence, zero-terminated and valid for ever.
SINEW_API const char* sinew_describe(sinew_error error);

typedef struct sinew_string {
  const char* data;  ///< UTF-8, not zero-terminated
  size_t length;
} sinew_string;

typedef struct sinew_vec2 {
  float x, y;
} sinew_vec2;
typedef struct sinew_vec3 {
  float x, y, z;
} sinew_vec3;
typedef struct sinew_vec4 {
  float x, y, z, w;
} sinew_vec4;
typedef struct sinew_affine {
  float row[3][4];
} sinew_affine;  ///< the fourth row (0 0 0 1) is implied
typedef struct sinew_joint_matrix {
  float column[4][4];
} sinew_joint_matrix;
typedef struct sinew_box {
  sinew_vec3 lower, upper;
} sinew_box;  ///< empty while lower > upper

typedef struct sinew_floats {
  const float* data;
  size_t count;
} sinew_floats;
typedef struct sinew_doubles {
  const double* data;
  size_t count;
} sinew_doubles;
typedef struct sinew_indices {
  const uint32_t* data;
  size_t count;
} sinew_indices;
typedef struct sinew_flags {
  const unsigned char* data;
  size_t count;
} sinew_flags;
typedef struct sinew_vec2s {
  const sinew_vec2* data;
  size_t count;
} sinew_vec2s;
typedef struct sinew_vec3s {
  const sinew_vec3* data;
  size_t count;
} sinew_vec3s;
typedef struct sinew_vec4s {
  const sinew_vec4* data;
  size_t count;
} sinew_vec4s;
typedef struct sinew_affines {
  const sinew_affine* data;
  size_t count;
} sinew_affines;
typedef struct sinew_joint_matrices {
  const sinew_joint_matrix* data;
  size_t count;
} sinew_joint_matrices;

/// Where frame memory comes from. Called while frame buffers are made and destroyed, never by a frame.
typedef struct sinew_allocator {
  void* context;
  void* (*allocate)(void* context, size_t byte_count, size_t alignment);  ///< null = out of memory
  void (*release)(void* context, void* block, size_t byte_count,
                  size_t alignment);  ///< with the numbers of the allocation
} sinew_allocator;

#ifdef __cplusplus
}
#endif
