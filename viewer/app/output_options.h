// SPDX-License-Identifier: MIT
#pragma once
#include <CLI/CLI.hpp>

#include "viewer/app/options.h"

namespace sinew::viewer {

/// Adds the options of time, and of what is written: pictures, films, sheets, comparisons.
void add_time_options(CLI::App& app, Options& options, CLI::Option* file);

/// Checks the rules between these options that CLI11's needs() and excludes() cannot express. `headless` then names the
/// file or folder to write, whatever its kind.
/// err  CLI::ValidationError
void check_outputs(const CLI::App& app, Options& options);

}  // namespace sinew::viewer
