// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace sinew::write {

/// A file and what it shall hold.
struct FileContent {
  std::filesystem::path file;
  std::span<const std::byte> bytes;
};

/// Writes files completely or not at all: each into a temporary file in its folder. When all are written they are
/// renamed over the old files, in the order given. Where a file is a symbolic link, the file behind it is replaced.
/// out   nothing, or why a file could not be written; older files are then unchanged, unless a rename itself failed
std::optional<std::string> replace_files(std::span<const FileContent> files);
std::optional<std::string> replace_file(const std::filesystem::path& file, std::span<const std::byte> bytes);

}  // namespace sinew::write
