// SPDX-License-Identifier: MIT
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "importer/tool/help/command_text.h"
#include "importer/tool/help/completions.h"

namespace sinew::tool {
namespace {

std::string in_single_quotes(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c;
  }
  return out + '\'';
}

std::string line_of(const std::string& condition, const OptionText& option) {
  std::string line = "complete -c sinew -n " + in_single_quotes(condition);
  for (const std::string& name : option.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!option.choices.empty())
    line += fmt::format(" -x -a {}", in_single_quotes(fmt::format("{}", fmt::join(option.choices, " "))));
  else if (option.names_path)
    line += " -r -F";
  else if (!option.value.empty())
    line += option.value_is_optional ? " -f" : " -x";
  return line + " -d " + in_single_quotes(option.about) + '\n';
}

}  // namespace

std::string fish_completion(const CLI::App& program) {
  std::string out = "# fish completion of sinew, made from its help\n";
  const char* const none = "__fish_use_subcommand";
  for (const OptionText& option : text_of(program).options) out += line_of(none, option);
  for (const CommandText& command : commands_of(program)) {
    out +=
        fmt::format("complete -c sinew -n {} -f -a {} -d {}\n", none, command.name, in_single_quotes(command.summary));
    for (const OptionText& option : command.options)
      out += line_of("__fish_seen_subcommand_from " + command.name, option);
  }
  return out;
}

}  // namespace sinew::tool
