// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "importer/tool/exit_code.h"

namespace sinew::tool {

/// The variable that an option sets. An optional or a list stays as it is when the option is not given.
using OptionTarget =
    std::variant<std::monostate, bool*, std::string*, std::optional<std::string>*, std::vector<std::string>*,
                 std::uint32_t*, std::uint64_t*, int*, double*, std::optional<double>*>;

/// An option, flag or positional argument of a command. Parser, help, manual page and completions read it.
struct Option {
  std::vector<std::string> names;  ///< "-o", "--output"; empty for an argument
  std::string value;               ///< Name of the value, "OUT"; empty for a flag. An argument has only this name.
  std::string about;
  OptionTarget target;
  std::vector<std::string> choices;        ///< All allowed values; empty = any.
  std::optional<double> least, most;       ///< Allowed range of a number.
  std::vector<std::string> other, needed;  ///< Names of options that exclude this one, and that it requires.
  std::string value_if_bare;  ///< Value of an option that is given without one; empty = a value is required.
  bool is_required = false;
  bool is_list = false;  ///< One value is a list with commas.
  /// Only for an argument after one that takes many: true if the last of the words belongs to this argument.
  bool (*takes_last)(const std::string& word) = nullptr;

  Option& required() {
    is_required = true;
    return *this;
  }
  Option& one_of(std::vector<std::string> values) {
    choices = std::move(values);
    return *this;
  }
  Option& within(double low, double high) {
    least = low;
    most = high;
    return *this;
  }
  Option& list() {
    is_list = true;
    return *this;
  }
  Option& bare(const char* text) {
    value_if_bare = text;
    return *this;
  }
  Option& excludes(const char* name) {
    other.emplace_back(name);
    return *this;
  }
  Option& needs(const char* name) {
    needed.emplace_back(name);
    return *this;
  }

  bool is_argument() const { return names.empty(); }
  bool takes_many() const { return is_argument() && std::holds_alternative<std::vector<std::string>*>(target); }
};

/// A command of the program: its options, and the function that runs it after they are parsed.
struct Command {
  /// A command without options.
  /// in   about   first line = summary of the command, the rest = details
  Command(std::string name, const std::string& about);

  /// Adds an option with a value. Returns it, so that its rules can be set.
  /// in   names  "-o,--output" or "--clip"      value  shown behind the name, "OUT"
  ///      target  must live as long as the command, for example in an object that `run` owns
  Option& option(const char* names, const char* value, OptionTarget target, std::string about);
  Option& flag(const char* names, bool& target, std::string about);
  Option& argument(const char* name, OptionTarget target, std::string about);

  std::string name, summary, details;
  std::deque<Option> options;  ///< In the order of the help; a deque keeps the references valid.
  std::function<ExitCode()> run;
};

/// A command that other builds have, but not this one.
struct LeftOutCommand {
  std::string name;
  std::string reason;  ///< "it was made without Embree"
};

/// The program: options and texts of its own, and its commands.
struct Program {
  Command self;
  std::string version, ending;
  std::vector<Command> commands;
  std::vector<LeftOutCommand> left_out;
};

}  // namespace sinew::tool
