// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/app/options.h"
#include "viewer/device/device.h"

namespace sinew::viewer {

/// How the program ends after work that went well: 0; 3 when validation was asked for and the layer complained or is
/// not installed. Says why on stderr.
int exit_code_after_validation(const Options& options, const Device& device);

}  // namespace sinew::viewer
