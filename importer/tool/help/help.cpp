// SPDX-License-Identifier: MIT
#include "importer/tool/help/help.h"

#include <algorithm>
#include <utility>

#include "importer/tool/wrapped_text.h"

namespace sinew::tool {
namespace {

using Row = std::pair<std::string, std::string>;

/// A table with two columns. A name that is too wide for the first column gets a line of its own.
std::string table(const std::string& title, const std::vector<Row>& rows) {
  constexpr std::size_t kWidestName = 26;
  std::size_t width = 0;
  for (const auto& [name, text] : rows)
    if (name.size() <= kWidestName) width = std::max(width, name.size());
  const std::size_t column = width + 4;
  std::string out = rows.empty() ? "" : "\n" + title + ":\n";
  for (const auto& [name, text] : rows) {
    out += "  " + name +
           (name.size() > width ? '\n' + std::string(column, ' ') : std::string(column - 2 - name.size(), ' '));
    out += wrapped(text, column, column) + '\n';
  }
  return out;
}

std::string joined(const std::vector<std::string>& words, const char* separator) {
  std::string text;
  for (const std::string& word : words) (text += text.empty() ? "" : separator) += word;
  return text;
}

std::string names_and_value(const Option& option) {
  const std::string value = option.value + (option.takes_many() ? "..." : "");
  return joined(option.names, ",") + (option.names.empty() || value.empty() ? "" : " ") + value;
}

/// `about`, with the choices and the bare value if it does not name them.
std::string full_text(const Option& option) {
  const auto is_named = [&](const std::string& word) {
    return (option.about + option.value).find(word) != std::string::npos;
  };
  std::string text = option.about;
  if (!option.value_if_bare.empty()) text += " (without a value: " + option.value_if_bare + ')';
  if (!std::all_of(option.choices.begin(), option.choices.end(), is_named))
    text += ". One of: " + joined(option.choices, ", ");
  return text;
}

std::string begin(const std::string& summary, const std::string& details) {
  return wrapped(summary, 0, 0) + '\n' + (details.empty() ? "" : '\n' + wrapped(details, 0, 0) + '\n');
}

}  // namespace

std::string help_text(const Program& program) {
  std::vector<Row> commands;
  for (const Command& command : program.commands) commands.emplace_back(command.name, command.summary);
  return begin("sinew: " + program.self.summary, program.self.details) + "\nUsage: sinew COMMAND ...\n" +
         table("Commands", commands) + table("Options", explained(program.self, false)) + '\n' +
         wrapped(program.ending, 0, 0) + '\n';
}

std::string help_text(const Command& command) {
  return begin(command.summary, command.details) + "\nUsage: " + wrapped(usage(command), 9, 7) + '\n' +
         table("Arguments", explained(command, true)) + table("Options", explained(command, false));
}

std::string usage(const Command& command) {
  std::string text = "sinew " + command.name + " [OPTIONS]";
  for (const Option& option : command.options)
    if (option.is_argument())
      text += option.is_required ? ' ' + names_and_value(option) : " [" + names_and_value(option) + ']';
  for (const Option& option : command.options)
    if (!option.is_argument() && option.is_required) text += ' ' + option.names.front() + ' ' + option.value;
  return text;
}

std::vector<Row> explained(const Command& command, bool arguments) {
  std::vector<Row> rows;
  for (const Option& option : command.options)
    if (option.is_argument() == arguments) rows.emplace_back(names_and_value(option), full_text(option));
  return rows;
}

}  // namespace sinew::tool
