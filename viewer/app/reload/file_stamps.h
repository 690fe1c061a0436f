// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>

namespace sinew::viewer {

/// Tells a file that was written again from one that was not: time and size differ.
struct FileStamp {
  std::filesystem::file_time_type written;
  std::uintmax_t bytes = 0;

  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// Files that exist, by absolute path.
using FileStamps = std::map<std::filesystem::path, FileStamp>;

/// The path by which FileStamps has a file: absolute, its folder without links. A link at its end stays.
std::filesystem::path stamp_key(const std::filesystem::path& file);

/// Stamps of these files. One that does not exist is left out, so it differs from itself as soon as it does.
/// in   files  as stamp_key has them
FileStamps stamps_of(std::span<const std::filesystem::path> files);

/// Adds the regular files of a folder, without those of the folders in it.
void add_stamps_in(const std::filesystem::path& folder, FileStamps& stamps);

}  // namespace sinew::viewer
