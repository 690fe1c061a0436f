// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/app/options.h"
#include "viewer/device/device.h"

namespace sinew::viewer {

/// Exit code after otherwise successful work. Returns 3 if --validate was given and the layer reported something or is
/// not installed, else 0. Prints the reason on stderr.
int exit_code_after_validation(const Options& options, const Device& device);

}  // namespace sinew::viewer
