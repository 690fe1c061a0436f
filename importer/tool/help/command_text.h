// SPDX-License-Identifier: MIT
#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace sinew::tool {

/// What people are told about one option or argument.
struct OptionText {
  std::vector<std::string> names;  ///< "-o", "--output"; empty for an argument
  std::string value;               ///< what follows the name, "OUT"; empty for a flag; the name of an argument
  std::string about;
  std::vector<std::string> choices;  ///< all values that are allowed; empty where there are others
  bool is_required = false;
  bool is_list = false;     ///< the value is a list with commas
  bool takes_many = false;  ///< an argument that stands for several
  bool names_path = false;  ///< the value is a file or a folder
  bool value_is_optional = false;
};

/// What people are told about one command, or about the whole program.
struct CommandText {
  std::string name, summary;  ///< one line
  std::string details;        ///< paragraphs; may be empty
  std::string ending;
  std::vector<OptionText> arguments, options;

  /// "sinew sample [OPTIONS] FILE"
  std::string usage() const;
};

/// Help, manual page and completions are made from this, so that they say the same. The first line of a description is
/// the summary.
CommandText text_of(const CLI::App& command);

/// The commands of a program, in the order in which they were added.
std::vector<CommandText> commands_of(const CLI::App& program);

/// "-o,--output OUT"
std::string names_and_value(const OptionText& option);

/// `about`, with choices and default where it does not name them.
std::string full_text(const OptionText& option);

}  // namespace sinew::tool
