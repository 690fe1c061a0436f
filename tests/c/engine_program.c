// SPDX-License-Identifier: MIT
#include "tests/c/engine_program.h"

void engine_write_program(double time_s, uint8_t mask, sinew_pose_op ops[engine_program_ops]) {
  ops[0] =
      (sinew_pose_op){.time_s = time_s, .weight = 1, .index = 0, .mask = SINEW_OP_NO_MASK, .kind = SINEW_OP_SAMPLE};
  ops[1] = sinew_default_op(SINEW_OP_EXTERNAL);
  ops[1].weight = 0.5f;
  ops[1].mask = mask;
  ops[2] = sinew_default_op(SINEW_OP_OVERLAY);
  ops[3] = sinew_default_op(SINEW_OP_OVERRIDE_JOINTS);
  ops[4] = sinew_default_op(SINEW_OP_PROCEDURE);
  ops[4].time_s = 0.75;
}

void engine_lift(void* context, const sinew_procedure_pose* pose) {
  const float height = *(const float*)context;
  sinew_transform transform;
  if (pose->struct_size < sizeof(*pose) || sinew_pose_get(&pose->local, 1, &transform) != SINEW_OK) return;
  transform.translation.y += height * pose->share;
  sinew_pose_set(&pose->local, 1, &transform);
  for (size_t w = 0; w < pose->weight_count; ++w) pose->weights[w] *= 0.5f;
}

sinew_error engine_place(const sinew_cut_pose* pose, sinew_vec3 place) {
  sinew_transform transform;
  const sinew_error error = sinew_pose_get(&pose->local, 1, &transform);
  if (error != SINEW_OK) return error;
  transform.translation = place;
  return sinew_pose_set(&pose->local, 1, &transform);
}
