// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/app/option_text.h"
#include "viewer/app/options.h"

namespace sinew::viewer {

/// Adds the options that look inside a character: --joint, --overlay and --paint.
void add_inspect_options(CLI::App& app, Options& options);

}  // namespace sinew::viewer
