// SPDX-License-Identifier: MIT
#include <string>
#include <string_view>

#include <fmt/core.h>

#include "importer/tool/help/help.h"

namespace sinew::tool {
namespace {

/// Text with a backslash before each of `special`, and `quote` in place of a single quote.
std::string escaped(std::string_view text, std::string_view special, std::string_view quote) {
  std::string out;
  for (const char c : text) {
    if (special.find(c) != special.npos) out += '\\';
    c == '\'' ? out += quote : out += c;
  }
  return out;
}

std::string in_fish(std::string_view text) { return '\'' + escaped(text, "\\", "\\'") + '\''; }
std::string in_zsh(std::string_view text) { return escaped(text, "[]:\\", "'\\''"); }

std::string all_names(const Command& command) {
  std::string names;
  for (const Option& option : command.options)
    for (const std::string& name : option.names) names += (names.empty() ? "" : " ") + name;
  return names;
}

/// The case statement of bash for the value of an option. Paths need none, because bash completes them itself.
std::string bash_value(const Command& command, const Option& option) {
  if (option.is_argument() || option.value.empty() || is_path(option) || !option.value_if_bare.empty()) return {};
  std::string patterns;
  for (const std::string& name : option.names)
    patterns += fmt::format("{}'{} {}'", patterns.empty() ? "" : "|", command.name, name);
  if (option.choices.empty()) return fmt::format("    {}) compopt +o default 2>/dev/null; return ;;\n", patterns);
  return fmt::format(
      "    {}) before=; {}COMPREPLY=($(compgen -P \"$before\" -W '{}' -- \"${{word##*,}}\")); return ;;\n", patterns,
      option.is_list ? "[[ $word == *,* ]] && before=${word%,*},\n      " : "", joined(option.choices, " "));
}

std::string fish_line(const std::string& condition, const Option& option) {
  std::string line = "complete -c sinew -n " + in_fish(condition);
  for (const std::string& name : option.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!option.choices.empty())
    line += " -x -a " + in_fish(joined(option.choices, " "));
  else if (!option.value.empty())
    line += is_path(option) ? " -r -F" : option.value_if_bare.empty() ? " -x" : " -f";
  return line + " -d " + in_fish(option.about) + '\n';
}

/// The words for an option that _arguments of zsh takes: "'--clip[One clip]:NAME:'".
std::string zsh_words(const Option& option) {
  std::string value;
  if (!option.value.empty()) {
    const std::string choices = joined(option.choices, " ");
    value = fmt::format("{}:{}:", option.value_if_bare.empty() ? "" : ":", in_zsh(option.value));
    if (!choices.empty()) value += option.is_list ? "_values -s , value " + choices : '(' + choices + ')';
    if (choices.empty() && (is_path(option) || option.is_argument())) value += "_files";
  }
  const std::string about = '[' + in_zsh(option.about) + ']';
  if (option.is_argument()) return fmt::format("'{}{}'", option.takes_many() ? "*" : "", value);
  if (option.names.size() == 1) return fmt::format("'*{}{}{}'", option.names[0], about, value);
  return fmt::format("'({})'{{{}}}'{}{}'", joined(option.names, " "), joined(option.names, ","), about, value);
}

/// All options, then all arguments: _arguments takes the first that fits.
std::string zsh_options(const Command& command) {
  std::string options, arguments;
  for (const Option& option : command.options)
    (option.is_argument() ? arguments : options) += " \\\n        " + zsh_words(option);
  return options + arguments;
}

}  // namespace

std::string bash_completion(const Program& program) {
  std::string words = all_names(program.self), values, options;
  for (const Command& command : program.commands) {
    words += ' ' + command.name;
    for (const Option& option : command.options) values += bash_value(command, option);
    options +=
        fmt::format("    {}) COMPREPLY=($(compgen -W '{}' -- \"$word\")) ;;\n", command.name, all_names(command));
  }
  return fmt::format(R"(# bash completion of sinew, made from its help
_sinew() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} command=${{COMP_WORDS[1]}} before
  COMPREPLY=()
  if [[ $COMP_CWORD -le 1 ]]; then
    COMPREPLY=($(compgen -W '{}' -- "$word"))
    return
  fi
  case "$command ${{COMP_WORDS[COMP_CWORD - 1]}}" in
{}  esac
  [[ $word == -* ]] || return
  case $command in
{}  esac
}}
complete -o default -F _sinew sinew
)",
                     words, values, options);
}

std::string fish_completion(const Program& program) {
  std::string out = "# fish completion of sinew, made from its help\n";
  const char* const none = "__fish_use_subcommand";
  for (const Option& option : program.self.options) out += fish_line(none, option);
  for (const Command& command : program.commands) {
    out += fmt::format("complete -c sinew -n {} -f -a {} -d {}\n", none, command.name, in_fish(command.summary));
    for (const Option& option : command.options)
      if (!option.is_argument()) out += fish_line("__fish_seen_subcommand_from " + command.name, option);
  }
  return out;
}

std::string zsh_completion(const Program& program) {
  std::string commands, cases;
  for (const Command& command : program.commands) {
    commands += fmt::format("    '{}:{}'\n", command.name, in_zsh(command.summary));
    cases += fmt::format("    {})\n      _arguments -s{} ;;\n", command.name, zsh_options(command));
  }
  return fmt::format(R"(#compdef sinew
# zsh completion of sinew, made from its help
_sinew() {{
  local -a commands=(
{}  )
  if (( CURRENT == 2 )); then
    _describe command commands
    _arguments{}
    return
  fi
  local command=$words[2]
  shift words
  (( CURRENT-- ))
  case $command in
{}  esac
}}
_sinew "$@"
)",
                     commands, zsh_options(program.self), cases);
}

std::optional<std::string> generated_text(const Program& program, std::string_view kind) {
  if (kind == "man") return man_page(program);
  if (kind == "bash") return bash_completion(program);
  if (kind == "zsh") return zsh_completion(program);
  if (kind == "fish") return fish_completion(program);
  return std::nullopt;
}

}  // namespace sinew::tool
