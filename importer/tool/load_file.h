// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include "importer/import_gltf.h"

namespace sinew::tool {

/// Imports a file. Progress is shown on a terminal; warnings and errors go to stderr.
/// out   nothing when the file cannot be imported; the command then ends with ExitCode::input_at_fault
std::optional<ImportedFile> load_file(const std::string& file, ImportOptions options = {});

}  // namespace sinew::tool
