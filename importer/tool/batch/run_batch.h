// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "importer/tool/batch/input_list.h"
#include "importer/tool/exit_code.h"

namespace sinew::tool {

/// The files of a command, and how they are worked on.
struct BatchOptions {
  std::vector<std::string> inputs;
  bool recursive = false;
  std::uint32_t jobs = 0;  ///< 0 = one for each core
  bool json = false;       ///< results are JSON: of several files one document a line
};

/// Adds --recursive and --jobs.
void add_batch_flags(CLI::App& command, BatchOptions& options);

/// The same, and FILE... as the command's inputs.
/// out   the option FILE
CLI::Option* add_batch_options(CLI::App& command, BatchOptions& options, const std::string& what);

/// Adds --recursive and --jobs, and positional arguments as `cp` has them: inputs, and one that comes last.
/// in    inputs, last  names for the help, what they are
///       is_last       whether the last of several arguments is the one: else all are inputs
/// out   the options of both; that of the last one is required unless the caller says otherwise
struct InputsAndLast {
  CLI::Option* inputs = nullptr;
  CLI::Option* last = nullptr;
};
struct ArgumentText {
  const char* name;
  std::string about;
};
InputsAndLast add_inputs_and_last(CLI::App& command, BatchOptions& options, std::string& last_value,
                                  const ArgumentText& inputs, const ArgumentText& last,
                                  bool (*is_last)(const std::string& argument));

/// The outputs of many files: one each, in a folder.
struct BatchOutput {
  std::string folder;     ///< empty = the command line names none
  std::string extension;  ///< with its dot
};

/// What a command does.
struct BatchWork {
  /// Works on one file. It is called on any thread, several at a time, and prints with print_result() and say_error().
  /// in   many   print one line instead of everything
  std::function<ExitCode(const Input& file, bool many)> run;
  /// Goes behind the summary of several files, such as "3 errors, 5 warnings". May be empty.
  std::function<std::string()> totals = {};
  /// For commands that write a file for each.
  std::optional<BatchOutput> output = std::nullopt;
  FileKind kind = FileKind::models;                ///< what folders stand for
  ExitCode bad_folder = ExitCode::input_at_fault;  ///< where a folder holds none of these, or cannot be read
};

/// Runs a command on all of its files. One file that is named prints what the command prints. Of several files each has
/// one line, in the order of the arguments whatever the jobs are; a summary follows, on stderr where results are JSON.
/// out   the worst outcome: wrong usage, then a machine that lacks something, then files that cannot be read, then
///       files at fault
ExitCode run_batch(const BatchOptions& options, const BatchWork& work);

}  // namespace sinew::tool
