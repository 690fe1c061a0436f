// SPDX-License-Identifier: MIT
#include "importer/tool/commands.h"

#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "importer/tool/help/program_text.h"
#include "importer/tool/messages.h"

namespace sinew::tool {
namespace {

/// What is wrong, and which help says what is right: that of the command when one was recognised, else that of sinew.
std::string usage_message(const CLI::App& program, const CLI::ParseError& error) {
  const std::vector<const CLI::App*> chosen =
      program.get_subcommands([](const CLI::App* command) { return command->parsed(); });
  if (!chosen.empty()) return fmt::format("{} (see `sinew {} --help`)", error.what(), chosen.front()->get_name());
  const std::vector<std::string> unknown = program.remaining();
  if (unknown.empty()) return fmt::format("{} (see `sinew --help`)", error.what());
  return fmt::format("there is no {} {} (see `sinew --help`)", unknown.front().starts_with('-') ? "option" : "command",
                     unknown.front());
}

ExitCode parse_and_run(CLI::App& program, const ExitCode& outcome, int argc, const char* const* argv) {
  try {
    program.parse(argc, argv);
    return outcome;
  } catch (const CLI::Success& help_or_version) {
    program.exit(help_or_version);
    return ExitCode::done;
  } catch (const CLI::ParseError& error) {
    return fail_with(ExitCode::wrong_usage, usage_message(program, error));
  } catch (const std::bad_alloc&) {
    say_error("not enough memory");
  } catch (const std::exception& error) {
    say_error(error.what());
  }
  return ExitCode::machine_lacks;
}

}  // namespace

ExitCode run_command_line(int argc, const char* const* argv) {
  CLI::App program("", "sinew");
  describe_program(program);
  add_generate(program);
  program.require_subcommand(1);
  ExitCode outcome = ExitCode::wrong_usage;
  add_info(program, outcome);
  add_sample(program, outcome);
  add_verify(program, outcome);
  add_check(program, outcome);
  add_plan(program, outcome);
  add_convert(program, outcome);
  add_retarget(program, outcome);
  add_compile(program, outcome);
  add_bake(program, outcome);
#ifdef SINEW_WITH_RAYS
  add_bake_ao(program, outcome);
#endif
#ifdef SINEW_WITH_COST
  add_cost(program, outcome);
#endif
  const ExitCode code = parse_and_run(program, outcome, argc, argv);
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  return fail_with(ExitCode::machine_lacks, "stdout cannot be written");
}

}  // namespace sinew::tool
