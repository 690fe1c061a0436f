// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include "importer/platform/program.h"
#include "importer/tool/commands.h"

int main(int argc, char** argv) {
  sinew::platform::prepare_standard_streams();
  const std::vector<std::string> words = sinew::platform::arguments_of(argc, argv);
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  return static_cast<int>(sinew::tool::run_command_line(static_cast<int>(pointers.size()), pointers.data()));
}
