// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/pose.h"
#include "runtime/c/pose_program.h"
#include "runtime/c/procedures/places.h"
#include "runtime/c/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

// Eyes that look at a target, with the ranges of VRM. A handle holds the eyes of one character and their target. A head
// that has to turn, too, turns before it (sinew_ik_set_aim).

typedef struct sinew_look_at sinew_look_at;

/// How far eyes move for an angle between the face and the target. This struct never grows.
typedef struct sinew_gaze_range {
  float most_rad;  ///< angle from which on the eyes move no farther
  float output;    ///< radians of joints, or the weight of an expression, at that angle
} sinew_gaze_range;

typedef enum sinew_eye_kind {
  SINEW_EYES_ARE_JOINTS = 0,
  SINEW_EYES_ARE_WEIGHTS = 1  ///< expressions move the eyes: sinew_gaze has their weights, and the pose stays
} sinew_eye_kind;

typedef struct sinew_eyes_setup {
  size_t struct_size;
  uint32_t kind;  ///< sinew_eye_kind
  uint32_t head;
  uint32_t left, right;       ///< joints of the eyes; SINEW_NONE = there is none
  sinew_vec3 between_eyes_m;  ///< place in the space of the head
  sinew_vec3 forward, up;     ///< directions of the face in model space, at rest
  sinew_gaze_range inner;     ///< of an eye towards the nose
  sinew_gaze_range outer;     ///< of an eye away from the nose; weights to both sides use it
  sinew_gaze_range down, upward;
  float fade_rad;  ///< angle from behind, above and below within which eyes go back to the middle; 0 = they snap
} sinew_eyes_setup;

/// A face along +z without eyes. All ranges are 0.17 rad for 90 degrees. A new handle has the weight 0.
SINEW_API sinew_eyes_setup sinew_default_eyes_setup(void);

/// Creates what turns the eyes of one character to a target.
/// in   scene  must outlive the handle
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_OUT_OF_MEMORY, SINEW_INDEX_OUT_OF_RANGE, SINEW_NOT_FINITE,
///      SINEW_NEGATIVE_WEIGHT (an angle below 0), SINEW_UNSUPPORTED (kind, an eye with a matrix, `up` along `forward`)
SINEW_API sinew_error sinew_look_at_create(const sinew_scene* scene, const sinew_eyes_setup* setup,
                                           sinew_look_at** out);
SINEW_API void sinew_look_at_destroy(sinew_look_at* look);

/// Sets the target. Do not call it while a frame in flight runs the handle.
/// in   target  in model space;   weight  [0, 1], 0 changes no pose
/// err  SINEW_NULL_ARGUMENT, SINEW_NOT_FINITE, SINEW_NOT_A_FRACTION. After an error the target set before stays
SINEW_API sinew_error sinew_look_at_set_target(sinew_look_at* look, const sinew_point* target, float weight);

/// Returns the handle as a procedure. Its version depends on the target, so get it again after each change.
/// err  SINEW_NULL_ARGUMENT
SINEW_API sinew_error sinew_look_at_procedure(sinew_look_at* look, sinew_pose_procedure* out);

/// Turns the eyes of a pose at once.
/// err  SINEW_NULL_ARGUMENT, SINEW_SIZE_MISMATCH;   cost no allocation
SINEW_API sinew_error sinew_look_at_run(sinew_look_at* look, const sinew_pose* local);

typedef struct sinew_gaze {
  size_t struct_size;
  int32_t error;             ///< sinew_error of the last run: SINEW_SIZE_MISMATCH if the pose was of another skeleton
  float yaw_rad, pitch_rad;  ///< of the target, seen from between the eyes; > 0 to the left of the face, and down
  float left, right, up, down;  ///< weights of expressions, for SINEW_EYES_ARE_WEIGHTS
  uint32_t is_limited;          ///< 1: an angle is beyond its range
} sinew_gaze;

/// Returns the result of the last run.
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE
SINEW_API sinew_error sinew_get_gaze(const sinew_look_at* look, sinew_gaze* out);

#ifdef __cplusplus
}
#endif
