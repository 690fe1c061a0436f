// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/app/options.h"
#include "viewer/device/device.h"

namespace sinew::viewer {

/// Exit code after work that succeeded: 0, or 3 when validation was asked for and the layer reported something or is
/// not installed. Prints the reason to stderr.
int exit_code_after_validation(const Options& options, const Device& device);

}  // namespace sinew::viewer
