// SPDX-License-Identifier: MIT
#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace sinew::tool {

/// The text of --help: for the program a line for each command, for a command everything. No line is wider than
/// kHelpWidth.
class HelpFormatter final : public CLI::FormatterBase {
 public:
  std::string make_help(const CLI::App* app, std::string, CLI::AppFormatMode) const override;
};

}  // namespace sinew::tool
