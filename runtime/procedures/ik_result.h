// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/base/result.h"

namespace sinew {

/// How a solver ended.
enum class IkStatus : std::uint8_t {
  idle,         ///< nothing was solved, because the weight is 0
  reached,      ///< the remaining error is within the tolerance
  limited,      ///< the bones could reach the goal, but a limit, the weight or the number of iterations stopped them
  unreachable,  ///< no rotation of these bones reaches the goal
};

/// Result of a solver: its status, and the error that remains between effector and goal in the pose that it wrote.
struct IkResult {
  IkStatus status = IkStatus::idle;
  ErrorCode error = ErrorCode::ok;  ///< why a procedure's goal was refused; the pose is then unchanged
  std::uint32_t iterations = 0;     ///< 0 for solvers in closed form
  float metres_left = 0.0f;         ///< in model space; largest error of an effector's place
  float radians_left = 0.0f;        ///< largest error of a direction or rotation

  friend bool operator==(const IkResult&, const IkResult&) = default;
};

}  // namespace sinew
