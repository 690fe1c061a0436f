// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/c/frame.h"
#include "runtime/c/handles.h"
#include "runtime/plan/frame_input.h"
#include "runtime/plan/refusal.h"

namespace sinew::c {

/// Why an input does not even get to the runtime. `where` has the place and always a rule; its code means nothing,
/// since some of C's have no twin.
struct [[nodiscard]] NotRead {
  sinew_error error = SINEW_OK;
  Refusal where;
};

/// Without a rule of its own, the sentence of the code is the rule.
NotRead refuse(sinew_error error, Refusal where) noexcept;

/// Room for the lists of a program: of each, as many entries as Needs::in.program has.
struct ProgramRoom {
  std::span<ExternalPose> externals;
  std::span<JointOverrides> overrides;
  std::span<PoseProcedure> procedures;
  std::span<JointMask> masks;
};

/// The same as C has it. Procedures are the caller's list.
struct ProgramRoomOfC {
  std::span<sinew_external_pose> externals;
  std::span<sinew_joint_overrides> overrides;
  std::span<sinew_joint_mask> masks;
  sinew_program_inputs* inputs = nullptr;
};

/// Room that owns its memory.
struct OwnProgramRoom {
  explicit OwnProgramRoom(const PoseProgramRoom& room)
      : externals(room.externals), overrides(room.overrides), procedures(room.procedures), masks(room.masks) {}
  ProgramRoom room() noexcept { return {externals, overrides, procedures, masks}; }

  std::vector<ExternalPose> externals;
  std::vector<JointOverrides> overrides;
  std::vector<PoseProcedure> procedures;
  std::vector<JointMask> masks;
};
struct OwnProgramRoomOfC {
  explicit OwnProgramRoomOfC(const PoseProgramRoom& room)
      : externals(room.externals), overrides(room.overrides), masks(room.masks) {}
  ProgramRoomOfC room() noexcept { return {externals, overrides, masks, &inputs}; }

  std::vector<sinew_external_pose> externals;
  std::vector<sinew_joint_overrides> overrides;
  std::vector<sinew_joint_mask> masks;
  sinew_program_inputs inputs{};
};

/// The program of a C caller as the runtime takes it. Operations, pages, planes, numbers and overridden joints are the
/// caller's own memory.
/// in   given  of this version
/// out  input  its program and program_inputs: views of `room` and of the caller's memory
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_NOT_IN_NEEDS (a list is longer than the needs
///      declare), SINEW_SIZE_MISMATCH (a pose that is not aligned), SINEW_UNSUPPORTED (unknown space)
NotRead read_program(const sinew_frame_input& given, const PoseProgramRoom& needs, const ProgramRoom& room,
                     FrameInput& input) noexcept;

/// The other way. Procedures are those that a C caller gave.
/// out  out  views of `room` and of what `input` views
void write_program(const FrameInput& input, const ProgramRoomOfC& room, sinew_frame_input& out) noexcept;

}  // namespace sinew::c
