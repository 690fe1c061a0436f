// SPDX-License-Identifier: MIT
#pragma once
#include <CLI/CLI.hpp>

#include "importer/tool/exit_code.h"

namespace sinew::tool {

/// Each function adds one command to the program. The command runs when it is parsed, and sets `outcome`.
void add_info(CLI::App& program, ExitCode& outcome);
void add_sample(CLI::App& program, ExitCode& outcome);
void add_verify(CLI::App& program, ExitCode& outcome);
void add_check(CLI::App& program, ExitCode& outcome);
void add_plan(CLI::App& program, ExitCode& outcome);
void add_compile(CLI::App& program, ExitCode& outcome);
void add_bake(CLI::App& program, ExitCode& outcome);
void add_bake_ao(CLI::App& program, ExitCode& outcome);  ///< in builds with Embree
void add_convert(CLI::App& program, ExitCode& outcome);
void add_retarget(CLI::App& program, ExitCode& outcome);
void add_cost(CLI::App& program, ExitCode& outcome);  ///< in builds with Google Benchmark

/// Runs the whole command line. `main` only calls this.
ExitCode run_command_line(int argc, const char* const* argv);

}  // namespace sinew::tool
