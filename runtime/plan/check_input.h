// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>

#include "runtime/base/index.h"
#include "runtime/base/result.h"
#include "runtime/plan/compiled_plan.h"
#include "runtime/plan/frame_input.h"

namespace sinew {

/// The largest weight of a layer, morph weight, and number of a root matrix. Blended sums, products of matrices and the
/// lengths of normals overflow from about 1e18 on.
inline constexpr float kLargestInput = 1e9f;

/// The first rule that an input breaks, and where: `list`[index].`field`, without the part that is not there.
struct Refusal {
  ErrorCode error = ErrorCode::ok;
  const char* field = nullptr;  ///< null: the rule is about the list as a whole
  const char* rule = nullptr;   ///< in words; null: those of describe(error) say all
  const char* list = nullptr;
  std::uint32_t index = kNone;
};

/// Checks what run_plan promises about its input.     cost O(layers + weights + sources). Internal to plan/
Refusal check_input(const CompiledPlan& plan, const FrameInput& input) noexcept;

}  // namespace sinew
