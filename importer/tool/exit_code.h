// SPDX-License-Identifier: MIT
#pragma once

namespace sinew::tool {

/// How the program ends. Other programs rely on these numbers.
enum class ExitCode : int {
  done = 0,
  input_at_fault = 1,  ///< the file, or the pose that it no longer gives; a message on stderr says what and where
  wrong_usage = 2,     ///< options or arguments that make no sense, for any file or for this one
  machine_lacks = 3,   ///< the disk is full, memory ran out
};

}  // namespace sinew::tool
