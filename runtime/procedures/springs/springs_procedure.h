// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>

#include "runtime/pose_program/program_inputs.h"
#include "runtime/procedures/springs/springs_job.h"

namespace sinew {

/// Springs as a procedure of a pose program. Each character needs its own object, with memory of the caller.
/// owns  nothing;  the state changes in each frame that runs
struct SpringsContext {
  const Springs* springs = nullptr;
  Affined root;       ///< as FrameInput::root, in double
  double dt_s = 0.0;  ///< seconds since the previous frame
  std::span<std::byte> state, scratch;
  SpringEvent event = SpringEvent::none;
  std::span<Vec3<double>> tails = {};
  SpringCounts counts;             ///< of the last run
  ErrorCode code = ErrorCode::ok;  ///< of the last run; if it is not ok, the pose is unchanged
};

/// The procedure of a context, for PoseProgramInputs::procedures. Its share is the weight of the springs. Moving
/// springs have version 0, so they run in each frame. Sleeping springs keep their version while `root` stays. If the
/// pose before them is unchanged too, the frame runs nothing.
/// in   context  must outlive the frame; `root`, `dt_s` and `event` are those of the next frame
SINEW_API PoseProcedure springs_procedure(SpringsContext& context) noexcept;

}  // namespace sinew
