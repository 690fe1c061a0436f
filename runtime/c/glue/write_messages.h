// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "runtime/c/handles.h"

namespace sinew::c {

/// Hands messages to a C caller, who owns them.
/// out  out  null = the caller wants none
inline void write_messages(std::vector<std::string> lines, sinew_messages** out) {
  if (out != nullptr) *out = new sinew_messages{std::move(lines)};
}

/// Hands over the one message about a refused file, and returns SINEW_BAD_FILE.
inline sinew_error bad_file(std::string line, sinew_messages** out) {
  write_messages({std::move(line)}, out);
  return SINEW_BAD_FILE;
}

}  // namespace sinew::c
