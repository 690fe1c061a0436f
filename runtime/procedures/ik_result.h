// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/base/result.h"

namespace sinew {

/// How a solver ended.
enum class IkStatus : std::uint8_t {
  idle,         ///< nothing was asked for: the weight is 0
  reached,      ///< what is left is within the tolerance
  limited,      ///< the bones could reach the goal, but a limit, the weight or the number of iterations stopped them
  unreachable,  ///< no rotation of these bones reaches the goal
};

/// The end of a solver, and what is left between effector and goal in the pose that it wrote.
struct IkResult {
  IkStatus status = IkStatus::idle;
  ErrorCode error = ErrorCode::ok;  ///< of a procedure whose job was refused; the pose is untouched then
  std::uint32_t iterations = 0;     ///< 0 for closed forms
  float metres_left = 0.0f;         ///< in model space; of the farthest effector
  float radians_left = 0.0f;        ///< between directions or rotations; the largest

  friend bool operator==(const IkResult&, const IkResult&) = default;
};

}  // namespace sinew
