// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>

namespace sinew::tool {

/// The records around the uncompressed files of a zip. Numbers that do not fit into the fields of the format go into
/// the longer fields of ZIP64, which are written only then.
/// in   size   of the file, in bytes;  at   where its local head begins in the zip

/// The header before a file.
std::string zip_local_head(const std::string& name, std::uint32_t checksum, std::uint64_t size);

/// The file's entry of the directory, which follows the last file.
std::string zip_directory_entry(const std::string& name, std::uint32_t checksum, std::uint64_t size, std::uint64_t at);

/// The record after the directory.
/// in   count   files in the zip
std::string zip_ending(std::uint64_t count, std::uint64_t directory_at, std::uint64_t directory_size);

}  // namespace sinew::tool
