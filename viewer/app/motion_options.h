// SPDX-License-Identifier: MIT
#pragma once
#include <CLI/CLI.hpp>

#include "viewer/app/options.h"

namespace sinew::viewer {

/// Adds the options of layers, root motion, springs and motion graphs.
void add_motion_options(CLI::App& app, Options& options, CLI::Option* file);

}  // namespace sinew::viewer
