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

// Feet that stay where they stand, on slopes and stairs. The clip plays on flat ground at the height of the root; y is
// up. A handle holds the feet of one character, with what they remember between frames.

typedef struct sinew_feet sinew_feet;

/// A leg and two points of its sole. This struct never grows.
typedef struct sinew_foot {
  uint32_t hip, knee, ankle;  ///< each below the previous one
  uint32_t toes;              ///< joint at the ball of the foot, or SINEW_NONE
  sinew_vec3 heel, tip;       ///< in the space of `ankle`, and of `toes` or else `ankle`
} sinew_foot;
#define SINEW_MOST_FEET 8

/// A leg whose sole is where the rest pose stands: at y = 0 of model space, below ankle and toes.
/// err  SINEW_NULL_ARGUMENT, SINEW_INDEX_OUT_OF_RANGE
SINEW_API sinew_error sinew_foot_on_rest_ground(const sinew_scene* scene, uint32_t hip, uint32_t knee, uint32_t ankle,
                                                uint32_t toes, sinew_foot* out);

typedef struct sinew_feet_setup {
  size_t struct_size;
  const sinew_foot* feet;     ///< copied
  size_t foot_count;          ///< at most SINEW_MOST_FEET
  uint32_t pelvis;            ///< joint above all legs, which comes down where the ground is low
  double lock_below_m_s;      ///< a foot is locked if its tip is low in the clip, and slower than this
  double free_above_m_s;      ///< a locked foot is released if its tip is faster in the clip
  double contact_height_m;    ///< height of the tip in the clip below which it is low
  double release_beyond_m;    ///< a locked foot is released at this horizontal distance from its clip
  double half_life_s;         ///< time in which the distance of a released foot from its clip halves
  double step_half_life_s;    ///< time in which the offset of a foot halves after the ground jumped
  double pelvis_half_life_s;  ///< time in which the distance of the pelvis from its goal halves
  double most_pelvis_m;       ///< limit of the pelvis's offset, up and down
  double most_slope_rad;      ///< a sole turns by no more
} sinew_feet_setup;

/// A setup without feet. All numbers have their default values.
SINEW_API sinew_feet_setup sinew_default_feet_setup(void);

/// Creates what keeps the feet of one character on the ground, with the state of each foot.
/// in   scene  must outlive the handle
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_OUT_OF_MEMORY, SINEW_SIZE_MISMATCH (too many feet),
///      SINEW_INDEX_OUT_OF_RANGE, SINEW_UNSUPPORTED (joints not in one line, a joint with a matrix), SINEW_NOT_FINITE,
///      SINEW_NOT_A_FRACTION (a half-life or limit below 0)
SINEW_API sinew_error sinew_feet_create(const sinew_scene* scene, const sinew_feet_setup* setup, sinew_feet** out);
SINEW_API void sinew_feet_destroy(sinew_feet* feet);

/// The ground below a place of the world. This struct never grows.
typedef struct sinew_ground_hit {
  double height_m;     ///< y of the ground
  sinew_point normal;  ///< of any length
} sinew_ground_hit;

/// Finds the ground below `place`, in the world. Called twice for each foot and frame, on the thread that runs the
/// frame; it must not throw or longjmp.
/// in   foot  index into the feet of the setup
/// out  hit, and 1; or 0 if there is no ground: the foot then keeps the height of its clip
typedef uint32_t (*sinew_ground_query)(void* context, size_t foot, const sinew_point* place, sinew_ground_hit* hit);

typedef struct sinew_feet_frame {
  size_t struct_size;
  sinew_affine_double root;  ///< from model space to the world: turns about y, one positive scale
  double dt_s;               ///< seconds since the previous frame, >= 0
  sinew_ground_query find;   ///< null = flat ground at the height of the root
  void* context;             ///< of `find`
} sinew_feet_frame;

/// A frame without ground: root identity, 0 s.
SINEW_API sinew_feet_frame sinew_default_feet_frame(void);

/// Sets the ground and the time step of the next run. Do not call it while a frame in flight runs the handle.
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_NOT_FINITE, SINEW_TIMES_NOT_INCREASING (dt_s below 0).
///      After an error the frame set before stays.   cost no allocation
SINEW_API sinew_error sinew_feet_begin_frame(sinew_feet* feet, const sinew_feet_frame* frame);

/// Returns the handle as a procedure of a pose program. Its version is 0, since feet follow the ground and the time.
/// err  SINEW_NULL_ARGUMENT
SINEW_API sinew_error sinew_feet_procedure(sinew_feet* feet, sinew_pose_procedure* out);

/// Runs the feet on a pose at once.
/// err  SINEW_NULL_ARGUMENT, SINEW_SIZE_MISMATCH;   cost no allocation
SINEW_API sinew_error sinew_feet_run(sinew_feet* feet, const sinew_pose* local);

typedef struct sinew_foot_result {
  size_t struct_size;
  uint32_t status;     ///< sinew_ik_status
  int32_t error;       ///< sinew_error of the last run: SINEW_SIZE_MISMATCH if the pose was of another skeleton
  uint32_t is_locked;  ///< 1: the foot stays where it stands
  float metres_left;   ///< between the ankle and its goal
  float tip_above_ground_m, heel_above_ground_m;  ///< in the pose that was written
} sinew_foot_result;

/// Returns the result of one foot in the last run.
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_INDEX_OUT_OF_RANGE
SINEW_API sinew_error sinew_get_foot_result(const sinew_feet* feet, size_t foot, sinew_foot_result* out);

/// The memory of the feet: plain bytes that can be copied and rolled back by the same version of the library. If all
/// bytes are zero, the next run has no history: it places the feet at once, as after a teleport.
SINEW_API size_t sinew_feet_state_bytes(void);
/// err  SINEW_NULL_ARGUMENT, SINEW_SIZE_MISMATCH (`size` is not sinew_feet_state_bytes)
SINEW_API sinew_error sinew_feet_get_state(const sinew_feet* feet, void* state, size_t size);
SINEW_API sinew_error sinew_feet_set_state(sinew_feet* feet, const void* state, size_t size);

#ifdef __cplusplus
}
#endif
