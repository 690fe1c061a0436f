// SPDX-License-Identifier: MIT
#include "importer/tool/help/help_formatter.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "importer/tool/help/command_text.h"
#include "importer/tool/help/wrapped_text.h"

namespace sinew::tool {
namespace {

using Row = std::pair<std::string, std::string>;

/// Two columns. A name that is too wide for the first one has a line of its own.
std::string table(const std::string& title, const std::vector<Row>& rows, std::size_t most_width) {
  if (rows.empty()) return {};
  std::size_t width = 0;
  for (const auto& [name, text] : rows)
    if (name.size() <= most_width) width = std::max(width, name.size());
  const std::size_t column = 2 + width + 2;
  std::string out = "\n" + title + ":\n";
  for (const auto& [name, text] : rows) {
    out += "  " + name;
    out += name.size() > width ? '\n' + std::string(column, ' ') : std::string(column - 2 - name.size(), ' ');
    out += wrapped(text, column, column) + '\n';
  }
  return out;
}

std::vector<Row> rows_of(const std::vector<OptionText>& options) {
  std::vector<Row> rows;
  for (const OptionText& option : options) rows.emplace_back(names_and_value(option), full_text(option));
  return rows;
}

constexpr std::size_t kWidestName = 26;

}  // namespace

std::string HelpFormatter::make_help(const CLI::App* app, std::string, CLI::AppFormatMode) const {
  const CommandText text = text_of(*app);
  const std::vector<CommandText> commands = commands_of(*app);
  std::string out = wrapped((commands.empty() ? "" : "sinew: ") + text.summary, 0, 0) + '\n';
  if (!text.details.empty()) out += '\n' + wrapped(text.details, 0, 0) + '\n';
  out += commands.empty() ? "\nUsage: " + wrapped(text.usage(), 9, 7) + '\n' : "\nUsage: sinew COMMAND ...\n";
  std::vector<Row> summaries;
  for (const CommandText& command : commands) summaries.emplace_back(command.name, command.summary);
  out += table("Commands", summaries, kWidestName);
  out += table("Arguments", rows_of(text.arguments), kWidestName);
  out += table("Options", rows_of(text.options), kWidestName);
  if (!text.ending.empty()) out += '\n' + wrapped(text.ending, 0, 0) + '\n';
  return out;
}

}  // namespace sinew::tool
