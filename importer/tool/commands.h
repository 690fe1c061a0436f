// SPDX-License-Identifier: MIT
#pragma once
#include "importer/tool/command.h"

namespace sinew::tool {

// Each function makes one command; program.cpp lists them.
Command info_command();
Command sample_command();
Command verify_command();
Command check_command();
Command plan_command();
Command convert_command();
Command import_command();
Command retarget_command();
Command compile_command();
Command simulate_command();
Command bake_command();
Command graph_command();
Command batch_command();
Command bake_ao_command();  ///< In builds with Embree.
Command cost_command();     ///< In builds with SINEW_COST.

/// The program with all its commands.
Program make_program();

/// Parses and runs a command line. `main` only calls this.
ExitCode run_command_line(int argc, const char* const* argv);

}  // namespace sinew::tool
