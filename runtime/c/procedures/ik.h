// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/pose.h"
#include "runtime/c/pose_program.h"
#include "runtime/c/procedures/ik_goals.h"
#include "runtime/c/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

// Inverse kinematics: limbs that reach targets, heads that look at them, chains and whole bodies. A handle holds one
// goal (ik_goals.h) and runs as a procedure of a pose program, or at once on a pose of the caller.

typedef struct sinew_ik sinew_ik;

typedef enum sinew_ik_status {
  SINEW_IK_IDLE = 0,     ///< the solver has not run, or its weight is 0
  SINEW_IK_REACHED = 1,  ///< the remaining error is within the tolerance
  SINEW_IK_LIMITED = 2,  ///< the goal is in reach, but a limit, the weight or the iterations ended it
  SINEW_IK_UNREACHABLE = 3
} sinew_ik_status;

typedef struct sinew_ik_result {
  size_t struct_size;
  uint32_t status;  ///< sinew_ik_status
  int32_t error;    ///< sinew_error of the last run: SINEW_SIZE_MISMATCH if the pose was of another skeleton
  uint32_t iterations;
  float metres_left, radians_left;  ///< largest remaining errors between effector and goal
} sinew_ik_result;

/// Creates a handle without a goal. Such a handle changes no pose.
/// in   scene  must outlive the handle
/// err  SINEW_NULL_ARGUMENT, SINEW_OUT_OF_MEMORY
SINEW_API sinew_error sinew_ik_create(const sinew_scene* scene, sinew_ik** out);
SINEW_API void sinew_ik_destroy(sinew_ik* ik);

/// Sets the goal. Do not set a handle that a frame in flight runs: use one handle for each frame in flight.
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_OUT_OF_MEMORY, SINEW_INDEX_OUT_OF_RANGE,
///      SINEW_PARENTS_NOT_FIRST, SINEW_UNSUPPORTED (joints not in one line, a joint with a matrix, no joint, an
///      enumeration), SINEW_NOT_FINITE, SINEW_NOT_NORMALISED, SINEW_NOT_A_FRACTION, SINEW_NEGATIVE_WEIGHT,
///      SINEW_TOO_LARGE. After an error the goal set before stays
/// cost O(goal); allocates where lists grow
SINEW_API sinew_error sinew_ik_set_two_bone(sinew_ik* ik, const sinew_two_bone_goal* goal);
SINEW_API sinew_error sinew_ik_set_aim(sinew_ik* ik, const sinew_aim_goal* goal);
SINEW_API sinew_error sinew_ik_set_chain(sinew_ik* ik, const sinew_chain_goal* goal);

/// Returns the handle as a procedure. Its version depends on the goal, so get it again after each change of the goal.
/// err  SINEW_NULL_ARGUMENT
SINEW_API sinew_error sinew_ik_procedure(sinew_ik* ik, sinew_pose_procedure* out);

/// Runs the goal on a pose at once.
/// err  SINEW_NULL_ARGUMENT, SINEW_SIZE_MISMATCH;   cost no allocation
SINEW_API sinew_error sinew_ik_solve(sinew_ik* ik, const sinew_pose* local);

/// Returns the result of the last run. A frame that reuses its pose runs nothing and leaves the result unchanged.
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE
SINEW_API sinew_error sinew_get_ik_result(const sinew_ik* ik, sinew_ik_result* out);

#ifdef __cplusplus
}
#endif
