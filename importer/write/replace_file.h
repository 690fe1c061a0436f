// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace sinew::write {

/// A file and its new content.
struct FileContent {
  std::filesystem::path file;
  std::span<const std::byte> bytes;
};

/// Replaces files atomically: writes temporary files in the same folders, then renames them in the given order. If a
/// file is a symbolic link, replaces its target.
/// out   empty, or why a file could not be written; then old files are unchanged, unless a rename failed
std::optional<std::string> replace_files(std::span<const FileContent> files);
std::optional<std::string> replace_file(const std::filesystem::path& file, std::span<const std::byte> bytes);

}  // namespace sinew::write
