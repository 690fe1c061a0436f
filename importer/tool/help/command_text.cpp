// SPDX-License-Identifier: MIT
#include "importer/tool/help/command_text.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

namespace sinew::tool {
namespace {

/// The parts of "METHOD:{a,b,c}", which CLI11 makes of a type's name and what is checked.
void split_type(const std::string& type, OptionText& out) {
  out.value = type.substr(0, type.find(':'));
  const std::size_t begin = type.find(":{"), end = type.find('}', begin == type.npos ? 0 : begin);
  if (begin == type.npos || end == type.npos) return;
  for (std::size_t at = begin + 2; at < end;) {
    const std::size_t comma = std::min(type.find(',', at), end);
    out.choices.push_back(type.substr(at, comma - at));
    at = comma + 1;
  }
}

bool is_name_of_path(const std::string& value) {
  const char* const words[] = {"FILE", "OUT", "IN", "DIR", "GOLDEN", "SOURCE", "CACHE", "FOLDER"};
  const std::string first = value.substr(0, value.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ"));
  return std::find(std::begin(words), std::end(words), first) != std::end(words);
}

/// What is said of an option, with its default where it has one and does not name it.
std::string with_default(const CLI::Option& option, bool value_is_optional) {
  const std::string text = option.get_description(), value = option.get_default_str();
  if (value.empty() || text.find("default") != text.npos) return text;
  return fmt::format("{} ({}{})", text, value_is_optional ? "without a value: " : "default: ", value);
}

OptionText text_of(const CLI::Option& option) {
  OptionText out;
  for (const std::string& name : option.get_snames()) out.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) out.names.push_back("--" + name);
  const bool is_flag = option.get_items_expected_max() == 0;
  if (!is_flag) split_type(option.get_type_name(), out);
  if (option.get_positional()) out.value = option.get_name(true);
  out.is_required = option.get_required();
  out.is_list = option.get_delimiter() != '\0';
  out.takes_many = option.get_positional() && option.get_items_expected_max() > 1;
  out.names_path = is_name_of_path(out.value);
  out.value_is_optional = !is_flag && option.get_items_expected_min() == 0;
  out.about = with_default(option, out.value_is_optional);
  return out;
}

bool is_hidden(const CLI::Option& option) { return option.get_group().empty(); }

bool names_all(const std::string& text, const std::vector<std::string>& words) {
  return std::all_of(words.begin(), words.end(), [&](const auto& word) { return text.find(word) != text.npos; });
}

}  // namespace

CommandText text_of(const CLI::App& command) {
  CommandText out{command.get_name(), {}, {}, {}, {}, {}};
  if (command.get_parent() == nullptr) out.ending = command.get_footer();  // which CLI11 hands on to commands
  const std::string about = command.get_description();
  const std::size_t line = std::min(about.find('\n'), about.size());
  out.summary = about.substr(0, line);
  out.details = about.substr(std::min(line + 1, about.size()));
  for (const CLI::Option* option : command.get_options({}))
    if (!is_hidden(*option)) (option->get_positional() ? out.arguments : out.options).push_back(text_of(*option));
  return out;
}

std::vector<CommandText> commands_of(const CLI::App& program) {
  std::vector<CommandText> out;
  for (const CLI::App* command : program.get_subcommands({})) out.push_back(text_of(*command));
  return out;
}

std::string CommandText::usage() const {
  std::string text = "sinew " + name + " [OPTIONS]";
  for (const OptionText& argument : arguments) {
    const std::string shown = argument.value + (argument.takes_many ? "..." : "");
    text += argument.is_required ? " " + shown : fmt::format(" [{}]", shown);
  }
  for (const OptionText& option : options)
    if (option.is_required) text += fmt::format(" {} {}", option.names.front(), option.value);
  return text;
}

std::string names_and_value(const OptionText& option) {
  std::string text = fmt::format("{}", fmt::join(option.names, ","));
  if (!text.empty() && !option.value.empty()) text += ' ';
  return text + option.value + (option.takes_many ? "..." : "");
}

std::string full_text(const OptionText& option) {
  if (option.choices.empty() || names_all(option.about + option.value, option.choices)) return option.about;
  return fmt::format("{}. One of: {}", option.about, fmt::join(option.choices, ", "));
}

}  // namespace sinew::tool
