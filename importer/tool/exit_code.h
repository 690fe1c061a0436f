// SPDX-License-Identifier: MIT
#pragma once

namespace sinew::tool {

/// The exit status of the program. Scripts rely on these numbers.
enum class ExitCode : int {
  done = 0,
  input_at_fault = 1,  ///< a file is broken, or its poses differ; a message on stderr says what and where
  wrong_usage = 2,     ///< options or arguments that do not make sense
  machine_lacks = 3,   ///< no disk space, no memory, an output that cannot be written
  cannot_read = 4,     ///< `sinew verify` only: nothing was compared, because a file cannot be read
};

}  // namespace sinew::tool
