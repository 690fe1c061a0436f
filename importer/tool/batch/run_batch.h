// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "importer/tool/batch/input_list.h"
#include "importer/tool/command.h"

namespace sinew::tool {

/// The files of a command, and how they are processed.
struct BatchOptions {
  std::vector<std::string> inputs;
  bool recursive = false;
  std::uint32_t jobs = 0;  ///< 0 = one for each core
  bool json = false;       ///< results are JSON; with several files one document per line
};

/// Adds --recursive, --jobs and the argument FILE..., the inputs of the command.
/// in    name   name of the argument in the help
/// out   the argument
Option& add_batch_options(Command& command, BatchOptions& options, const char* about, const char* name = "FILE");

/// The outputs of many files: one for each input, in a folder.
struct BatchOutput {
  std::string folder;     ///< empty = the command line names no folder
  std::string extension;  ///< extension of the outputs, including its dot
};

/// The work of a command, for run_batch().
struct BatchWork {
  /// Works on one file. It is called on any thread, several at a time, and prints with print_result() and
  /// print_error().
  /// in   many   print one line instead of everything
  std::function<ExitCode(const Input& file, bool many)> run;
  /// Text for the end of the summary of several files, such as "3 errors, 5 warnings". May be empty.
  std::function<std::string()> totals = {};
  /// For commands that write one output for each file.
  std::optional<BatchOutput> output = std::nullopt;
  FileKind kind = FileKind::models;                ///< the files that a folder stands for
  ExitCode bad_folder = ExitCode::input_at_fault;  ///< exit code if a folder holds no such file, or cannot be read
};

/// Runs a command on all of its files. For a single named file it prints everything. For several files it prints one
/// line each, in the order of the arguments for any number of jobs. A summary follows, on stderr if results are JSON.
/// out   the worst outcome: wrong usage, then a machine that lacks something, then files that cannot be read, then
///       files at fault
ExitCode run_batch(const BatchOptions& options, const BatchWork& work);

}  // namespace sinew::tool
