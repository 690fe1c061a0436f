// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>

namespace sinew::tool {

/// What stands around the files of a zip that are stored as they are. Numbers that do not fit into the fields of the
/// format are in the longer ones of ZIP64, which is there only for them.
/// in   size   of the file, in bytes;  at   where its local head begins in the zip

/// What stands before a file.
std::string zip_local_head(const std::string& name, std::uint32_t checksum, std::uint64_t size);

/// The file's entry of the directory, which follows the last file.
std::string zip_directory_entry(const std::string& name, std::uint32_t checksum, std::uint64_t size, std::uint64_t at);

/// What follows the directory.
/// in   count   files in the zip
std::string zip_ending(std::uint64_t count, std::uint64_t directory_at, std::uint64_t directory_size);

}  // namespace sinew::tool
