// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/result.h"
#include "runtime/plan/compiled_plan.h"
#include "runtime/plan/frame_input.h"

namespace sinew {

/// Checks what run_plan promises about its input.     cost O(layers + weights + sources). Internal to plan/
ErrorCode check(const CompiledPlan& plan, const FrameInput& input) noexcept;

}  // namespace sinew
