// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>

#include "runtime/pose_program/program_inputs.h"
#include "runtime/procedures/springs/springs_job.h"

namespace sinew {

/// Springs as a step of a pose program. One object for each character, with memory of the caller.
/// owns  nothing;  the state changes in each frame that runs
struct SpringsContext {
  const Springs* springs = nullptr;
  Affined root;       ///< as FrameInput::root, in double
  double dt_s = 0.0;  ///< since the frame before
  std::span<std::byte> state, scratch;
  SpringEvent event = SpringEvent::none;
  std::span<Vec3<double>> tails = {};
  SpringCounts counts;             ///< of the last run
  ErrorCode code = ErrorCode::ok;  ///< of the last run; the pose stays as it is where it is not ok
};

/// The procedure of a context, for PoseProgramInputs::procedures. Its share is the weight of the springs. Springs in
/// motion have version 0, so they run in each frame. Springs that sleep keep one version while `root` stays: if the
/// pose before them has not changed either, the frame runs nothing at all.
/// in   context  lives as long as the frame; `root`, `dt_s` and `event` are those of the frame to come
SINEW_API PoseProcedure springs_procedure(SpringsContext& context) noexcept;

}  // namespace sinew
