// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include "importer/tool/exit_code.h"

namespace sinew::tool {

/// Tells about a file of compiled clips; nothing when the file is none.
std::optional<ExitCode> tell_about_clips(const std::string& file, bool json);

}  // namespace sinew::tool
