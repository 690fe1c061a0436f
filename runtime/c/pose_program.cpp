// SPDX-License-Identifier: MIT
#include "runtime/c/pose_program.h"

#include <cstddef>

#include "runtime/c/glue/call.h"
#include "runtime/c/glue/enums.h"
#include "runtime/c/program_room.h"

using namespace sinew;

namespace {

// Programs of the C API are read in place, since both structs have the same layout.
static_assert(sizeof(sinew_pose_op) == sizeof(PoseOp) && alignof(sinew_pose_op) == alignof(PoseOp) &&
              offsetof(sinew_pose_op, time_s) == offsetof(PoseOp, time_s) &&
              offsetof(sinew_pose_op, weight) == offsetof(PoseOp, weight) &&
              offsetof(sinew_pose_op, index) == offsetof(PoseOp, index) &&
              offsetof(sinew_pose_op, mask) == offsetof(PoseOp, mask) &&
              offsetof(sinew_pose_op, kind) == offsetof(PoseOp, kind));
static_assert(SINEW_OP_NO_MASK == PoseOp::kNoMask && SINEW_MOST_OPS == kMostPoseOps);

}  // namespace

sinew_pose_op sinew_default_op(std::uint32_t kind) {
  const bool is_full =
      // For these kinds `time_s` is a threshold or a share, whose default is 1.
      kind == SINEW_OP_MEAN || kind == SINEW_OP_OVERRIDE_JOINTS || kind == SINEW_OP_PROCEDURE;
  const std::uint8_t own = c::kEnum<PoseOpKind>.has(kind) ? static_cast<std::uint8_t>(kind) : std::uint8_t{0xFF};
  const std::uint16_t steps = kind == SINEW_OP_INERTIALIZE || kind == SINEW_OP_DEAD_BLEND ? 1 : 0;
  return {.time_s = is_full ? 1.0 : 0.0, .weight = 1.0f, .index = steps, .mask = SINEW_OP_NO_MASK, .kind = own};
}

sinew_error sinew_program_room_of(const sinew_pose_op* ops, std::size_t op_count, sinew_program_room* room) {
  return c::call(c::given(room, c::Array{ops, op_count}), [&] {
    const PoseProgramSpan program(reinterpret_cast<const PoseOp*>(ops), op_count);
    return c::write_fields(c::kProgramRoom, room_of(program), room);
  });
}

sinew_error sinew_raise_program_room(sinew_program_room* room, const sinew_program_room* other) {
  return c::call(c::given(room, other), [&] {
    PoseProgramRoom a, b;
    if (const sinew_error error = c::read_fields(room, c::kProgramRoom, a)) return error;
    if (const sinew_error error = c::read_fields(other, c::kProgramRoom, b)) return error;
    return c::write_fields(c::kProgramRoom, larger(a, b), room);
  });
}
