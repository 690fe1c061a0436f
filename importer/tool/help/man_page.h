// SPDX-License-Identifier: MIT
#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace sinew::tool {

/// The manual page sinew(1), in the man macros of roff, from what --help says of all commands.
std::string man_page(const CLI::App& program);

}  // namespace sinew::tool
