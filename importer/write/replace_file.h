// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace sinew::write {

/// Writes a file completely or not at all: into a temporary file in the same folder, which is then renamed over the old
/// file. Where `file` is a symbolic link, the file behind it is replaced.
/// out   nothing, or why the file could not be written; an older file is then unchanged
std::optional<std::string> replace_file(const std::filesystem::path& file, std::span<const std::byte> bytes);

}  // namespace sinew::write
