// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace sinew {

/// Recognises a file that is not glTF by its first bytes: archives, other model formats, failed downloads.
/// out   the kind of file and the next step, such as "gzip data; unpack it (gunzip) and import what is inside".
///       Empty if the file may be glTF: it starts with "glTF", or with "{" or "[" as JSON does
/// cost  O(size)
std::optional<std::string> describe_foreign_file(std::span<const std::byte> file);

/// Recognises small texts that servers and version control leave in place of a file: a Git LFS or git-annex pointer, a
/// web page. Never matches a valid image. Buffers may hold any bytes, but not these by chance.
/// out   as describe_foreign_file()
std::optional<std::string> describe_stand_in(std::span<const std::byte> file);

}  // namespace sinew
