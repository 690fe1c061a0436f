// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>

namespace sinew::viewer {

/// Identifies a state of a file by modification time and size.
struct FileStamp {
  std::filesystem::file_time_type written;
  std::uintmax_t bytes = 0;

  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// Stamps of existing files, by absolute path.
using FileStamps = std::map<std::filesystem::path, FileStamp>;

/// The key of a file in FileStamps: an absolute path whose folder has its links resolved. A link in the last component
/// is kept.
std::filesystem::path stamp_key(const std::filesystem::path& file);

/// Stamps of these files. Missing files have no entry, so the map changes when they appear.
/// in   files  paths from stamp_key
FileStamps stamps_of(std::span<const std::filesystem::path> files);

/// Adds the regular files of a folder, not recursively.
void add_stamps_in(const std::filesystem::path& folder, FileStamps& stamps);

}  // namespace sinew::viewer
