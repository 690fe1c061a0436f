// SPDX-License-Identifier: MIT
#include <string>

#include <fmt/format.h>

#include "importer/tool/help/command_text.h"
#include "importer/tool/help/completions.h"

namespace sinew::tool {
namespace {

/// What comes after a name: choices, a file, or anything. Names files where nothing is printed here.
void put_values(std::string& out, const CommandText& command, const OptionText& option) {
  if (option.value.empty() || option.names_path || option.value_is_optional) return;
  std::string patterns;
  for (const std::string& name : option.names)
    patterns += fmt::format("{}'{} {}'", patterns.empty() ? "" : "|", command.name, name);
  if (option.choices.empty())
    out += fmt::format("    {}) compopt +o default 2>/dev/null; return ;;\n", patterns);
  else if (option.is_list)
    out += fmt::format(
        "    {}) before=; [[ $word == *,* ]] && before=${{word%,*}},\n"
        "      COMPREPLY=($(compgen -P \"$before\" -W '{}' -- \"${{word##*,}}\")); return ;;\n",
        patterns, fmt::join(option.choices, " "));
  else
    out += fmt::format("    {}) COMPREPLY=($(compgen -W '{}' -- \"$word\")); return ;;\n", patterns,
                       fmt::join(option.choices, " "));
}

std::string all_names(const CommandText& command) {
  std::string names;
  for (const OptionText& option : command.options)
    for (const std::string& name : option.names) names += (names.empty() ? "" : " ") + name;
  return names;
}

}  // namespace

std::string bash_completion(const CLI::App& program) {
  const auto commands = commands_of(program);
  std::string words = all_names(text_of(program)), values, options;
  for (const CommandText& command : commands) {
    words += " " + command.name;
    for (const OptionText& option : command.options) put_values(values, command, option);
    options +=
        fmt::format("    {}) COMPREPLY=($(compgen -W '{}' -- \"$word\")) ;;\n", command.name, all_names(command));
  }
  return fmt::format(
      "# bash completion of sinew, made from its help\n"
      "_sinew() {{\n"
      "  local word=${{COMP_WORDS[COMP_CWORD]}} command=${{COMP_WORDS[1]}} before\n"
      "  COMPREPLY=()\n"
      "  if [[ $COMP_CWORD -le 1 ]]; then\n"
      "    COMPREPLY=($(compgen -W '{}' -- \"$word\"))\n"
      "    return\n"
      "  fi\n"
      "  case \"$command ${{COMP_WORDS[COMP_CWORD - 1]}}\" in\n{}  esac\n"
      "  [[ $word == -* ]] || return\n"
      "  case $command in\n{}  esac\n"
      "}}\n"
      "complete -o default -F _sinew sinew\n",
      words, values, options);
}

}  // namespace sinew::tool
