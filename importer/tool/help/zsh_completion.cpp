// SPDX-License-Identifier: MIT
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "importer/tool/help/command_text.h"
#include "importer/tool/help/completions.h"

namespace sinew::tool {
namespace {

/// Text between single quotes, in which _arguments and _describe give brackets and colons a meaning.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return out;
}

/// ":OUT:_files", ":METHOD:(a b)", or ":N:" where anything may follow.
std::string value_of(const OptionText& option) {
  if (option.value.empty()) return {};
  std::string action;
  if (!option.choices.empty() && option.is_list)
    action = fmt::format("_values -s , {} {}", "value", fmt::join(option.choices, " "));
  else if (!option.choices.empty())
    action = fmt::format("({})", fmt::join(option.choices, " "));
  else if (option.names_path)
    action = "_files";
  return fmt::format("{}:{}:{}", option.value_is_optional ? ":" : "", escaped(option.value), action);
}

std::string spec_of(const OptionText& option) {
  const std::string about = fmt::format("[{}]", escaped(option.about));
  if (option.names.empty())
    return fmt::format("'{}{}'", option.takes_many ? "*" : "", ":" + escaped(option.value) + ":_files");
  if (option.names.size() == 1) return fmt::format("'*{}{}{}'", option.names[0], about, value_of(option));
  return fmt::format("'({})'{{{}}}'{}{}'", fmt::join(option.names, " "), fmt::join(option.names, ","), about,
                     value_of(option));
}

std::string specs_of(const CommandText& command) {
  std::string specs;
  for (const auto* list : {&command.options, &command.arguments})
    for (const OptionText& option : *list) specs += " \\\n        " + spec_of(option);
  return specs;
}

}  // namespace

std::string zsh_completion(const CLI::App& program) {
  std::string commands, cases;
  for (const CommandText& command : commands_of(program)) {
    commands += fmt::format("    '{}:{}'\n", command.name, escaped(command.summary));
    cases += fmt::format("    {})\n      _arguments -s{} ;;\n", command.name, specs_of(command));
  }
  return fmt::format(
      "#compdef sinew\n"
      "# zsh completion of sinew, made from its help\n"
      "_sinew() {{\n"
      "  local -a commands=(\n{}  )\n"
      "  if (( CURRENT == 2 )); then\n"
      "    _describe command commands\n"
      "    _arguments{}\n"
      "    return\n"
      "  fi\n"
      "  local command=$words[2]\n"
      "  shift words\n"
      "  (( CURRENT-- ))\n"
      "  case $command in\n{}  esac\n"
      "}}\n"
      "_sinew \"$@\"\n",
      commands, specs_of(text_of(program)), cases);
}

}  // namespace sinew::tool
