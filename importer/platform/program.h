// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "importer/platform/files.h"

/// Calls of the operating system about this process and its machine, in program_posix.cpp and program_windows.cpp. All
/// texts are UTF-8.
namespace sinew::platform {

inline constexpr int kStandardInput = 0, kStandardOutput = 1, kStandardError = 2;  ///< descriptors

/// Prepares the standard streams for bytes and UTF-8. Windows would add a carriage return to each end of line and show
/// text in the code page of the console. Call it once, before anything is printed.
void prepare_standard_streams();

/// Splits the command line into words.   in   argc, argv   of main(); in Windows in the code page of the system
std::vector<std::string> arguments_of(int argc, const char* const* argv);

/// Reads an environment variable.   out   empty if it is not set
std::string environment_variable(const char* name);

/// True if a descriptor is a terminal, on Windows one that takes escape sequences. False for files and pipes.
bool is_terminal(int descriptor) noexcept;

std::uint64_t process_number() noexcept;

/// Finds the user's cache folder.   out   empty if there is none
std::filesystem::path user_cache_folder();

/// Finds the folder of the running program.   out   empty if the system does not tell
std::filesystem::path program_folder();

/// Adds .exe to the name of a program on Windows.
std::string program_file(const std::string& name);

/// How a program ended, and what it printed.
struct EndedProgram {
  int status = 0;      ///< its exit status; 128 + N if signal N ended it
  std::string output;  ///< its stdout, with its stderr in between if that was wanted
};

/// Runs a program and waits for its end. It inherits the environment, and reads nothing.
/// in   with_messages  false: its stderr is discarded
/// err  a sentence for the user, if the program cannot be started
tl::expected<EndedProgram, std::string> run_program(const std::filesystem::path& program,
                                                    const std::vector<std::string>& arguments, bool with_messages);

/// The stdout of a program.
/// err  a sentence for the user, if the program cannot be started or does not end with status 0
inline tl::expected<std::string, std::string> output_of(const std::filesystem::path& program,
                                                        const std::vector<std::string>& arguments) {
  auto ended = run_program(program, arguments, false);
  if (!ended) return tl::unexpected(ended.error());
  const std::string name = text_of(program.filename());
  if (ended->status > 128) return tl::unexpected(name + " was ended by signal " + std::to_string(ended->status - 128));
  if (ended->status != 0) return tl::unexpected(name + " ended with status " + std::to_string(ended->status));
  return std::move(ended->output);
}

// Facts for reports; "unknown" if the system does not tell.
std::string processor_name();
std::string system_name();
std::string load_average();

}  // namespace sinew::platform
