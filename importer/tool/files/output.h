// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "importer/tool/exit_code.h"

// An output is a file, the standard output, or anything that takes bytes from begin to end: a pipe, /dev/null, a
// terminal. Only files are replaced, complete or not at all.
namespace sinew::tool {

/// True for "-" and for the names of the standard output, such as /dev/stdout.
bool is_standard_output(const std::filesystem::path& output);

/// True for the standard output, and for a pipe or a character device of that name.
bool is_stream(const std::filesystem::path& output);

/// Checks an output before any work is done. It must not be a file that is read, whatever path or link leads to it. It
/// must not be a folder or a block device, and its folder must exist.
/// in    inputs   ImportedFile::Facts::files, and others that the command reads
/// out   a sentence, or nothing
std::optional<std::string> find_output_error(const std::filesystem::path& output,
                                             std::span<const std::filesystem::path> inputs);

/// Writes all bytes of an output. Prints an error.
ExitCode write_output(const std::filesystem::path& output, std::span<const std::byte> bytes);

}  // namespace sinew::tool
