// SPDX-License-Identifier: MIT
#pragma once
#include <cstdio>
#include <string>

namespace sinew::viewer {

/// Writes a line on stderr, behind the name of the program.
inline void log_line(const std::string& line) { std::fprintf(stderr, "sinew-viewer: %s\n", line.c_str()); }

}  // namespace sinew::viewer
