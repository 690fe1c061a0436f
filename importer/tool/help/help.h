// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "importer/tool/command.h"

// Everything here is made from the descriptions that the parser reads, so help, manual and completions agree with it.
namespace sinew::tool {

/// The text of --help: a line for each command of the program, or everything about one command.
std::string help_text(const Program& program);
std::string help_text(const Command& command);

/// The manual page sinew(1), in the man macros of roff.
std::string man_page(const Program& program);

/// Scripts with which shells complete commands, options and values.
std::string bash_completion(const Program& program);
std::string zsh_completion(const Program& program);
std::string fish_completion(const Program& program);

/// One of the texts above.
/// in    kind   "man", "bash", "zsh" or "fish"; nothing is returned for others
std::optional<std::string> generated_text(const Program& program, std::string_view kind);

/// "sinew sample [OPTIONS] FILE... -o OUT"
std::string usage(const Command& command);

/// "-o,--output OUT"
std::string names_and_value(const Option& option);

/// The full text about an option: `about`, and its choices and bare value if `about` does not name them.
std::string full_text(const Option& option);

/// True if the value of an option is a file or a folder, which the name of the value tells.
bool is_path(const Option& option);

/// Words with `separator` between them.
std::string joined(const std::vector<std::string>& words, std::string_view separator);

}  // namespace sinew::tool
