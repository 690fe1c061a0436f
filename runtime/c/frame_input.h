// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/c/frame.h"
#include "runtime/c/handles.h"
#include "runtime/c/program_input.h"
#include "runtime/plan/frame_input.h"

namespace sinew::c {

/// Room for what an input lists.
struct InputRoom {
  std::span<ClipLayer> layers;        ///< [plan.input_room()]
  std::span<GeometryInput> geometry;  ///< [plan.geometry_room()]
  ProgramRoom program;
};

/// The same as C has it.
struct InputRoomOfC {
  std::span<sinew_layer> layers;
  std::span<const sinew_page*> pages;  ///< as many
  std::span<sinew_geometry_input> geometry;
  ProgramRoomOfC program;
};

/// Room that owns its memory.
struct OwnInputRoom {
  explicit OwnInputRoom(const sinew_plan& plan)
      : layers(plan.input_room()), geometry(plan.geometry_room()), program(plan.plan.needs().in.program) {}
  InputRoom room() noexcept { return {layers, geometry, program.room()}; }

  std::vector<ClipLayer> layers;
  std::vector<GeometryInput> geometry;
  OwnProgramRoom program;
};

/// The input of a C caller as the runtime takes it.
/// in   given  null = the rest pose
/// out  input  views of `room` and of the caller's weights
/// err  SINEW_WRONG_STRUCT_SIZE, SINEW_NULL_ARGUMENT, SINEW_TOO_MANY_LAYERS, SINEW_SIZE_MISMATCH (more weights or
///      instances that play than room), SINEW_UNSUPPORTED (unknown kind), SINEW_NOT_IN_NEEDS (interpolation), those of
///      read_program
NotRead read_input(const sinew_frame_input* given, const sinew_plan& plan, const InputRoom& room,
                   FrameInput& input) noexcept;

/// Layers of a C caller.
/// in   pages  [count] or null;   list  its name, for refusals
/// err  SINEW_NULL_ARGUMENT, SINEW_TOO_MANY_LAYERS, SINEW_UNSUPPORTED (kind)
NotRead read_layers(const sinew_layer* given, const sinew_page* const* pages, std::size_t count, const char* list,
                    std::span<ClipLayer> room, std::span<const ClipLayer>& layers) noexcept;

/// The other way: an input of the runtime for a C caller.
/// out  out  views of `room` and of what `input` views
sinew_error write_input(const FrameInput& input, InputRoomOfC room, sinew_frame_input* out) noexcept;

}  // namespace sinew::c
