// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/sinew.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { engine_program_ops = 5 };

/// A clip, half of a pose of the caller over it where the caller's first mask allows, joints that the caller places,
/// three quarters of a procedure.
/// in   mask  index of the caller's first mask
void engine_write_program(double time_s, uint8_t mask, sinew_pose_op ops[engine_program_ops]);

/// A procedure: lifts joint 1 by its share of a height and halves the morph weights.
/// in   context  the height, a float
void engine_lift(void* context, const sinew_procedure_pose* pose);

/// Moves joint 1 of a pose at its cut to a place.
sinew_error engine_place(const sinew_cut_pose* pose, sinew_vec3 place);

#ifdef __cplusplus
}
#endif
