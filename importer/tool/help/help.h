// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "importer/tool/command.h"

// Everything here is made from the descriptions that the parser reads, so help, manual and completions agree with it.
namespace sinew::tool {

/// The text of --help: a line for each command of the program, or everything about one command.
std::string help_text(const Program& program);
std::string help_text(const Command& command);

/// The manual page sinew(1), in the man macros of roff.
std::string man_page(const Program& program);

/// Words that may stand in place of the last one, as "word<Tab>description" lines. There are none where files belong.
/// in   words   of the command line after "sinew", up to the one that is being typed
std::string candidates(const Program& program, const std::vector<std::string>& words);

/// "sinew sample [OPTIONS] FILE... -o OUT"
std::string usage(const Command& command);

/// "-o,--output OUT" and what it means, for the options or for the arguments of a command.
std::vector<std::pair<std::string, std::string>> explained(const Command& command, bool arguments);

}  // namespace sinew::tool
