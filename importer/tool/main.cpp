// SPDX-License-Identifier: MIT
#include "importer/tool/commands.h"

int main(int argc, char** argv) { return static_cast<int>(sinew::tool::run_command_line(argc, argv)); }
