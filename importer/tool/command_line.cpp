// SPDX-License-Identifier: MIT
// The only file that includes CLI11, which takes seconds to compile. Commands describe their options by command.h.
#include <algorithm>
#include <cstdio>
#include <exception>
#include <iterator>
#include <new>
#include <string_view>
#include <type_traits>

#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include "importer/tool/commands.h"
#include "importer/tool/help/help.h"
#include "importer/tool/messages.h"

namespace sinew::tool {
namespace {

using Words = std::vector<std::string>;

/// Stores the words of an option in its target.
/// out   false: a word that must be a number is none
bool store(const Option& option, const Words& words) {
  return std::visit(
      [&](auto target) {
        using Target = decltype(target);
        if constexpr (std::is_same_v<Target, std::monostate>) {
          return true;
        } else if constexpr (std::is_same_v<Target, Words*>) {
          *target = words;
          return true;
        } else {
          using Value = std::remove_pointer_t<Target>;
          const std::string& word = words.back();
          if constexpr (std::is_same_v<Value, std::string> || std::is_same_v<Value, std::optional<std::string>>) {
            *target = word;
            return true;
          } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
            return CLI::detail::lexical_cast(word, target->emplace());
          } else {
            return CLI::detail::lexical_cast(word, *target);
          }
        }
      },
      option.target);
}

std::string parser_name(const Option& option) {
  if (option.is_argument()) return option.value;
  std::string names;
  for (const std::string& name : option.names) names += (names.empty() ? "" : ",") + name;
  return names;
}

CLI::Option* add_option(CLI::App& app, const Option& option) {
  if (option.value.empty())
    return app.add_flag_callback(parser_name(option), [&option] { *std::get<bool*>(option.target) = true; });
  CLI::Option* out = app.add_option(parser_name(option),
                                    CLI::callback_t([&option](const Words& words) { return store(option, words); }));
  if (std::holds_alternative<Words*>(option.target)) out->expected(CLI::detail::expected_max_vector_size);
  if (!option.is_argument()) out->allow_extra_args(false);
  if (option.is_list) out->delimiter(',');
  if (!option.value_if_bare.empty()) out->expected(0, 1)->default_str(option.value_if_bare);
  if (!option.choices.empty()) out->check(CLI::IsMember(option.choices));
  if (option.least) {
    const bool has_fraction =
        std::holds_alternative<double*>(option.target) || std::holds_alternative<std::optional<double>*>(option.target);
    if (has_fraction)
      out->check(CLI::Range(*option.least, *option.most));
    else
      out->check(CLI::Range(static_cast<std::int64_t>(*option.least), static_cast<std::int64_t>(*option.most)));
  }
  return out->required(option.is_required);
}

/// Arguments in the manner of `cp`: `many` gets all words, and hands the last word on if `last` takes it. The last word
/// is known only when all words are there.
void add_many_before_last(CLI::App& app, const Option& many, const Option& last) {
  const auto share_out = [&app, &many, &last](const Words& words) {
    Words& inputs = *std::get<Words*>(many.target) = words;
    if (words.size() < 2 || !last.takes_last(words.back())) return true;
    inputs.pop_back();
    app.get_option(last.value)->add_result(words.back());
    return true;
  };
  app.add_option(many.value, CLI::callback_t(share_out))
      ->expected(CLI::detail::expected_max_vector_size)
      ->required(many.is_required);
}

void add_options(CLI::App& app, const std::deque<Option>& options) {
  const auto last = std::find_if(options.begin(), options.end(), [](const Option& o) { return o.takes_last; });
  for (const Option& option : options) {
    if (std::holds_alternative<std::monostate>(option.target)) continue;  // --help and --version are CLI11's own
    if (last != options.end() && option.takes_many())
      add_many_before_last(app, option, *last);
    else
      add_option(app, option);
  }
  for (const Option& option : options) {
    const auto parsed = [&](const std::string& name) { return app.get_option(name); };
    const auto self = [&] { return parsed(option.is_argument() ? option.value : option.names.back()); };
    for (const std::string& name : option.other) self()->excludes(parsed(name));
    for (const std::string& name : option.needed) self()->needs(parsed(name));
  }
}

/// The command that the words name; null if none.
const Command* chosen_command(const CLI::App& app, const Program& program) {
  for (const Command& command : program.commands)
    if (app.get_subcommand(command.name)->parsed()) return &command;
  return nullptr;
}

/// The command that the user named, if this build does not have it; else null.
const LeftOutCommand* left_out_command(const CLI::App& app, const Program& program) {
  const Words unknown = app.remaining();
  for (const LeftOutCommand& command : program.left_out)
    if (!unknown.empty() && unknown.front() == command.name) return &command;
  return nullptr;
}

/// The fault of a command line, and which help explains it: that of the command if one is named, else that of the
/// program.
std::string usage_message(const CLI::App& app, const Command* command, const CLI::ParseError& error) {
  if (command != nullptr) return fmt::format("{} (see `sinew {} --help`)", error.what(), command->name);
  const Words unknown = app.remaining();
  if (unknown.empty()) return fmt::format("{} (see `sinew --help`)", error.what());
  return fmt::format("there is no {} {} (see `sinew --help`)", unknown.front().starts_with('-') ? "option" : "command",
                     unknown.front());
}

void print(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stdout); }

ExitCode parse_and_run(int argc, const char* const* argv) {
  const Program program = make_program();
  const Words words(argv + std::min(argc, 1), argv + argc);
  if (words == Words{"--man-page"}) {  // used by the build; the help does not show it
    print(man_page(program));
    return ExitCode::done;
  }
  if (!words.empty() && words.front() == "--complete") {  // for shells (help/shells/)
    print(candidates(program, {words.begin() + 1, words.end()}));
    return ExitCode::done;
  }
  CLI::App app("", "sinew");
  app.set_version_flag("--version", program.version)->configurable(false);
  app.set_help_flag("-h,--help");
  app.require_subcommand(1);
  for (const Command& command : program.commands) add_options(*app.add_subcommand(command.name), command.options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForVersion&) {
    print(program.version + '\n');
    return ExitCode::done;
  } catch (const CLI::CallForHelp&) {
    const Command* command = chosen_command(app, program);
    print(command != nullptr ? help_text(*command) : help_text(program));
    return ExitCode::done;
  } catch (const CLI::ParseError& error) {
    if (const LeftOutCommand* command = left_out_command(app, program))
      return fail_with(ExitCode::machine_lacks,
                       fmt::format("this build of sinew has no `{}`: {}", command->name, command->reason));
    return fail_with(ExitCode::wrong_usage, usage_message(app, chosen_command(app, program), error));
  }
  return chosen_command(app, program)->run();
}

}  // namespace

ExitCode run_command_line(int argc, const char* const* argv) {
  ExitCode code = ExitCode::machine_lacks;
  try {
    code = parse_and_run(argc, argv);
  } catch (const std::bad_alloc&) {
    print_error("not enough memory");
  } catch (const std::exception& error) {
    print_error(error.what());
  }
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  return fail_with(ExitCode::machine_lacks, "stdout cannot be written");
}

}  // namespace sinew::tool
