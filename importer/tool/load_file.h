// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include "importer/import_gltf.h"

namespace sinew::tool {

/// Imports a file, or "-": the standard input. Progress is shown on a terminal; warnings and errors go to stderr, one
/// line for each rule.
/// out   empty if the file cannot be imported; the command then ends with ExitCode::input_at_fault
std::optional<ImportedFile> load_file(const std::string& file, const ImportOptions& options = {});

/// Imports a file without printing messages, for commands that show the warnings themselves.
ImportResult<ImportedFile> import_with_progress(const std::string& file, ImportOptions options);

/// Prints the warnings, then the errors.
void print_import_error(const std::string& file, const ImportError& error);

}  // namespace sinew::tool
