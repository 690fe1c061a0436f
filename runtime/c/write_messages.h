// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "runtime/c/handles.h"

namespace sinew::c {

/// Gives lines to a C caller that wants them.
/// out  out  null = not wanted
inline void write_messages(std::vector<std::string> lines, sinew_messages** out) {
  if (out != nullptr) *out = new sinew_messages{std::move(lines)};
}

/// The same of a file that was refused.
inline sinew_error bad_file(std::string line, sinew_messages** out) {
  write_messages({std::move(line)}, out);
  return SINEW_BAD_FILE;
}

}  // namespace sinew::c
