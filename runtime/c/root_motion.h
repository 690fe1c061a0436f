// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/library.h"
#include "runtime/c/playback.h"
#include "runtime/c/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A rigid motion in double precision: real + e dual, real the unit rotation, dual = t real / 2.
typedef struct sinew_dual_quat {
  double real[4], dual[4];  ///< x y z w
} sinew_dual_quat;

// Null stands for the identity.
SINEW_API sinew_dual_quat sinew_dual_quat_identity(void);
SINEW_API sinew_dual_quat sinew_dual_quat_product(const sinew_dual_quat* a,
                                                  const sinew_dual_quat* b);  ///< applies b first; the result is unit
SINEW_API sinew_dual_quat sinew_dual_quat_inverse(const sinew_dual_quat* motion);
/// The matrix for sinew_frame_input.root
SINEW_API sinew_affine sinew_dual_quat_matrix(const sinew_dual_quat* motion);

/// How much of a root joint's turn carries the character.
typedef enum sinew_root_turn {
  SINEW_ROOT_TURN_NONE = 0,
  SINEW_ROOT_TURN_HEADING = 1,  ///< about +Y only, by the twist of the rotation
  SINEW_ROOT_TURN_FULL = 2,
  SINEW_ROOT_TURN_HEADING_EULER = 3  ///< about +Y only, by Euler angles: the direction of +X seen from above
} sinew_root_turn;

/// The part of a root joint's movement that carries the character through the world; the rest stays in its pose.
typedef struct sinew_root_parts {
  size_t struct_size;
  uint32_t x, y, z;  ///< 1 or 0: translation along the axes of the joint's parent space
  uint32_t turn;     ///< a value of sinew_root_turn
} sinew_root_parts;
SINEW_API sinew_root_parts sinew_default_root_parts(void);  ///< x, z and the heading

/// The position and rotation to which a clip has moved the character at a clip time.
/// in   joint  the root joint;   parts  null = sinew_default_root_parts
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_INDEX_OUT_OF_RANGE (clip, joint), SINEW_NOT_FINITE,
///      SINEW_UNSUPPORTED (turn), SINEW_OUT_OF_MEMORY (if the joint has tracks in several parts of the animation)
SINEW_API sinew_error sinew_root_place(const sinew_scene* scene, uint32_t clip, uint32_t joint,
                                       const sinew_root_parts* parts, double time_s, sinew_dual_quat* out);

/// How far the character moves in a step of the clock, in its own space. Each round of a loop continues where the last
/// one ended, so neither the frame rate nor the number of rounds matters.
///
///     sinew_clock_advance(&clock, dt_s, &step);
///     sinew_root_motion(scene, clip, joint, NULL, &step, &motion);
///     world = sinew_dual_quat_product(&world, &motion);
///     sinew_root_place(scene, clip, joint, NULL, sinew_clock_time_s(&clock), &place);
///     inverse = sinew_dual_quat_inverse(&place);                 // takes the motion out of the pose
///     root = sinew_dual_quat_product(&world, &inverse);
///     input.root = sinew_dual_quat_matrix(&root);
///
/// err  as sinew_root_place; SINEW_NOT_FINITE and SINEW_UNSUPPORTED also for a step that no clock made
SINEW_API sinew_error sinew_root_motion(const sinew_scene* scene, uint32_t clip, uint32_t joint,
                                        const sinew_root_parts* parts, const sinew_step* step, sinew_dual_quat* out);

/// Root motion of one clip of a library, from the keys of its compiled clip. It keeps no reference to scene or library.
typedef struct sinew_root_track sinew_root_track;

/// Creates the root motion of a library's clip for a scene.
/// in   library  contains the clip, which is bound to the scene by names as in sinew_plan_create_from_library
/// err  as sinew_root_place, and SINEW_OUT_OF_MEMORY
/// cost O(names + clips * (joints + weights + properties) + keys of the joint), allocates
SINEW_API sinew_error sinew_root_track_create(const sinew_scene* scene, const sinew_library* library, uint32_t clip,
                                              uint32_t joint, const sinew_root_parts* parts, sinew_root_track** out);
SINEW_API void sinew_root_track_destroy(sinew_root_track* track);

/// Like sinew_root_place, from the track.
/// err  SINEW_NULL_ARGUMENT, SINEW_NOT_FINITE
SINEW_API sinew_error sinew_root_track_place(const sinew_root_track* track, double time_s, sinew_dual_quat* out);
/// Like sinew_root_motion, from the track.
/// err  SINEW_NULL_ARGUMENT; SINEW_NOT_FINITE and SINEW_UNSUPPORTED for a step that no clock made
SINEW_API sinew_error sinew_root_track_motion(const sinew_root_track* track, const sinew_step* step,
                                              sinew_dual_quat* out);

#ifdef __cplusplus
}
#endif
