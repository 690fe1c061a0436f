// SPDX-License-Identifier: MIT
#include "runtime/c/pose_program.h"

#include <cstddef>
#include <limits>

#include "runtime/c/boundary.h"
#include "runtime/c/program_room.h"

using namespace sinew;

namespace {

static_assert(sizeof(sinew_pose_op) == sizeof(PoseOp) && alignof(sinew_pose_op) == alignof(PoseOp) &&
              offsetof(sinew_pose_op, time_s) == offsetof(PoseOp, time_s) &&
              offsetof(sinew_pose_op, weight) == offsetof(PoseOp, weight) &&
              offsetof(sinew_pose_op, index) == offsetof(PoseOp, index) &&
              offsetof(sinew_pose_op, mask) == offsetof(PoseOp, mask) &&
              offsetof(sinew_pose_op, kind) == offsetof(PoseOp, kind));
static_assert(SINEW_OP_NO_MASK == PoseOp::kNoMask && SINEW_MOST_OPS == kMostPoseOps);

constexpr bool is_kind(PoseOpKind kind, sinew_op_kind of_c) noexcept {
  return static_cast<int>(kind) == static_cast<int>(of_c);
}
static_assert(is_kind(PoseOpKind::rest, SINEW_OP_REST) && is_kind(PoseOpKind::sample, SINEW_OP_SAMPLE) &&
              is_kind(PoseOpKind::sample_mirrored, SINEW_OP_SAMPLE_MIRRORED) &&
              is_kind(PoseOpKind::rest_mirrored, SINEW_OP_REST_MIRRORED) &&
              is_kind(PoseOpKind::external, SINEW_OP_EXTERNAL) && is_kind(PoseOpKind::mean, SINEW_OP_MEAN) &&
              is_kind(PoseOpKind::overlay, SINEW_OP_OVERLAY) &&
              is_kind(PoseOpKind::overlay_model, SINEW_OP_OVERLAY_MODEL) &&
              is_kind(PoseOpKind::add_to_rest, SINEW_OP_ADD_TO_REST) && is_kind(PoseOpKind::add, SINEW_OP_ADD) &&
              is_kind(PoseOpKind::override_joints, SINEW_OP_OVERRIDE_JOINTS) &&
              is_kind(PoseOpKind::procedure, SINEW_OP_PROCEDURE));

constexpr std::uint32_t kMostEntries = std::numeric_limits<std::uint16_t>::max();  // that PoseOp::index can count
constexpr std::uint32_t kMostMasks = PoseOp::kNoMask;

sinew_program_room room_for_c(const PoseProgramRoom& room) noexcept {
  return {.struct_size = 0,
          .ops = room.ops,
          .slots = room.slots,
          .externals = room.externals,
          .overrides = room.overrides,
          .procedures = room.procedures,
          .masks = room.masks,
          .overridden_joints = room.overridden_joints,
          .overlays_in_model_space = room.overlays_in_model_space};
}

/// err  SINEW_WRONG_STRUCT_SIZE
sinew_error read_numbers(const sinew_program_room* given, PoseProgramRoom& room) noexcept {
  sinew_program_room own{};
  if (const sinew_error error = c::read_struct(given, own); error != SINEW_OK) return error;
  room = {.ops = own.ops,
          .slots = own.slots,
          .externals = own.externals,
          .overrides = own.overrides,
          .masks = own.masks,
          .procedures = own.procedures,
          .overridden_joints = own.overridden_joints,
          .overlays_in_model_space = own.overlays_in_model_space != 0};
  return SINEW_OK;
}

}  // namespace

sinew_error c::read_program_room(const sinew_program_room* given, PoseProgramRoom& room) noexcept {
  if (const sinew_error error = read_numbers(given, room); error != SINEW_OK) return error;
  const bool is_usable = room.ops <= kMostPoseOps && room.slots <= room.ops && room.masks <= kMostMasks &&
                         room.externals <= kMostEntries && room.overrides <= kMostEntries &&
                         room.procedures <= kMostEntries;
  return is_usable ? SINEW_OK : SINEW_UNSUPPORTED;
}

sinew_pose_op sinew_default_op(std::uint32_t kind) {
  const bool is_full =
      kind == SINEW_OP_MEAN || kind == SINEW_OP_OVERRIDE_JOINTS || kind == SINEW_OP_PROCEDURE;  // by threshold or share
  const std::uint8_t own = kind <= SINEW_OP_PROCEDURE ? static_cast<std::uint8_t>(kind) : std::uint8_t{0xFF};
  return {.time_s = is_full ? 1.0 : 0.0, .weight = 1.0f, .index = 0, .mask = SINEW_OP_NO_MASK, .kind = own};
}

sinew_error sinew_program_room_of(const sinew_pose_op* ops, std::size_t op_count, sinew_program_room* room) {
  if (room == nullptr || (ops == nullptr && op_count > 0)) return SINEW_NULL_ARGUMENT;
  return c::write_struct(room_for_c(room_of({reinterpret_cast<const PoseOp*>(ops), op_count})), room);
}

sinew_error sinew_raise_program_room(sinew_program_room* room, const sinew_program_room* other) {
  if (room == nullptr || other == nullptr) return SINEW_NULL_ARGUMENT;
  PoseProgramRoom a, b;
  if (const sinew_error error = read_numbers(room, a); error != SINEW_OK) return error;
  if (const sinew_error error = read_numbers(other, b); error != SINEW_OK) return error;
  return c::write_struct(room_for_c(larger(a, b)), room);
}
