// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/messages.h"
#include "runtime/c/pose.h"
#include "runtime/c/pose_program.h"
#include "runtime/c/procedures/springs_setup.h"
#include "runtime/c/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

// Springs of hair, cloth and soft parts. Ticks of a fixed length give the same motion at any frame rate. sinew_springs
// is a definition, which all characters on one scene share. sinew_spring_motion is the motion of one character.

typedef struct sinew_springs sinew_springs;
typedef struct sinew_spring_motion sinew_spring_motion;

/// Prepares springs. Joints that lie between two joints of a spring are carried along.
/// in   scene  must outlive the handle
/// out  why  one line that names list, index and rule if the setup cannot be used; may be null
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_OUT_OF_MEMORY, SINEW_INDEX_OUT_OF_RANGE (also a joint with
///      two springs), SINEW_UNSUPPORTED (an enumeration, a joint with a matrix), SINEW_NOT_FINITE, SINEW_TOO_LARGE,
///      SINEW_NEGATIVE_WEIGHT, SINEW_NOT_A_FRACTION
SINEW_API sinew_error sinew_springs_create(const sinew_scene* scene, const sinew_springs_setup* setup,
                                           sinew_springs** out, sinew_messages** why);
SINEW_API void sinew_springs_destroy(sinew_springs* springs);

/// Creates the springs' state of one character, which starts at rest.
/// in   springs  must outlive the motion
/// err  SINEW_NULL_ARGUMENT, SINEW_OUT_OF_MEMORY
SINEW_API sinew_error sinew_spring_motion_create(const sinew_springs* springs, sinew_spring_motion** out);
SINEW_API void sinew_spring_motion_destroy(sinew_spring_motion* motion);

typedef enum sinew_spring_event {
  SINEW_SPRINGS_GO_ON = 0,
  SINEW_SPRINGS_RESET = 1,    ///< springs jump to their goals and rest there
  SINEW_SPRINGS_TELEPORT = 2  ///< springs move along and keep their swing
} sinew_spring_event;

typedef struct sinew_spring_frame {
  size_t struct_size;
  sinew_affine_double root;  ///< world transform above all root joints
  double dt_s;               ///< seconds since the previous frame, >= 0
  uint32_t event;            ///< sinew_spring_event
  sinew_point* tails;        ///< [tail_count] receives the places of tails in the world, in the order of the setup's
                             ///< joints, whenever the handle runs; null = not wanted. Sleeping springs with it work
  size_t tail_count;         ///< 0, or at least the joints of the setup
} sinew_spring_frame;

/// Root identity, 0 s, no event.
SINEW_API sinew_spring_frame sinew_default_spring_frame(void);

/// Sets the root, the time step and the event of the next run. Do not call it while a frame in flight runs the handle.
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_UNSUPPORTED (event), SINEW_NOT_FINITE,
///      SINEW_TIMES_NOT_INCREASING (dt_s below 0), SINEW_SIZE_MISMATCH (tails). After an error the frame set before
///      stays.   cost no allocation
SINEW_API sinew_error sinew_spring_motion_begin_frame(sinew_spring_motion* motion, const sinew_spring_frame* frame);

/// Returns the motion as a procedure of a pose program; get it again in each frame. Its version is 0 while the springs
/// move. If they sleep it stays, so frames with an unchanged pose run nothing.
/// err  SINEW_NULL_ARGUMENT
SINEW_API sinew_error sinew_spring_motion_procedure(sinew_spring_motion* motion, sinew_pose_procedure* out);

/// Runs the springs on a pose at once.
/// err  SINEW_NULL_ARGUMENT, SINEW_SIZE_MISMATCH;   cost no allocation
SINEW_API sinew_error sinew_spring_motion_run(sinew_spring_motion* motion, const sinew_pose* local);

typedef struct sinew_spring_result {
  size_t struct_size;
  int32_t error;           ///< sinew_error of the last run: SINEW_SIZE_MISMATCH if the pose was of another skeleton
  uint32_t ticks, joints;  ///< simulated ticks, and joints summed over them; 0 = asleep
  uint32_t dropped_ticks;  ///< because of max_ticks
  uint32_t is_asleep;      ///< 1 or 0
} sinew_spring_result;

/// Returns the result of the last run.
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE
SINEW_API sinew_error sinew_get_spring_result(const sinew_spring_motion* motion, sinew_spring_result* out);

/// The memory of the motion: plain bytes that can be copied and rolled back by the same version of the library and the
/// same springs. All zero = the next frame starts at rest.
SINEW_API size_t sinew_spring_motion_state_bytes(const sinew_spring_motion* motion);
/// err  SINEW_NULL_ARGUMENT, SINEW_SIZE_MISMATCH (`size` is not sinew_spring_motion_state_bytes)
SINEW_API sinew_error sinew_spring_motion_get_state(const sinew_spring_motion* motion, void* state, size_t size);
SINEW_API sinew_error sinew_spring_motion_set_state(sinew_spring_motion* motion, const void* state, size_t size);

#ifdef __cplusplus
}
#endif
