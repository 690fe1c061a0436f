// SPDX-License-Identifier: MIT
#pragma once
#include <CLI/CLI.hpp>

namespace sinew::tool {

/// Gives the program its description, its ending, --help, --version and the form of all help.
void describe_program(CLI::App& program);

/// Adds --generate man|bash|zsh|fish, which prints a manual page or completions. No help shows it: the build uses it.
void add_generate(CLI::App& program);

}  // namespace sinew::tool
