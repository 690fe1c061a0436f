// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace sinew::tool {

/// Why a file must not be written, found before any work is done. An output never takes the place of a file that is
/// read, whatever path, symbolic or hard link leads to it, and of nothing but a regular file.
/// in    inputs   ImportedFile::Facts::files, and others that the command reads
/// out   nothing, or a sentence for people
std::optional<std::string> check_output_path(const std::filesystem::path& output,
                                             std::span<const std::filesystem::path> inputs);

}  // namespace sinew::tool
