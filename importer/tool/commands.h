// SPDX-License-Identifier: MIT
#pragma once
#include <CLI/CLI.hpp>

#include "importer/tool/exit_code.h"

namespace sinew::tool {

/// Each adds one command to the program; when that command is called, it runs and leaves its outcome in `outcome`.
void add_info(CLI::App& program, ExitCode& outcome);
void add_sample(CLI::App& program, ExitCode& outcome);
void add_verify(CLI::App& program, ExitCode& outcome);
void add_check(CLI::App& program, ExitCode& outcome);
void add_plan(CLI::App& program, ExitCode& outcome);
void add_compile(CLI::App& program, ExitCode& outcome);
void add_convert(CLI::App& program, ExitCode& outcome);
void add_cost(CLI::App& program, ExitCode& outcome);  ///< in builds with Google Benchmark

/// The whole command line; `main` is only this.
ExitCode run_command_line(int argc, const char* const* argv);

}  // namespace sinew::tool
