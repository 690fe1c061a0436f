// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <span>

#include "importer/issue_log.h"

namespace sinew {

/// The two parts of a file: its JSON text and, for a .glb, the BIN chunk. Both point into the file's bytes.
struct Container {
  std::span<const std::byte> json;
  std::optional<std::span<const std::byte>> bin;
};

/// True where the bytes start like a binary container ("glTF"), whatever the file is called.
bool looks_like_glb(std::span<const std::byte> file) noexcept;

/// Takes a .glb apart. Everything is checked against the true size before it is used.
/// eq   12 bytes header (magic, version, length), then chunks of 8 bytes header (length, type) and their data, JSON
///      first, at most one BIN after it; unknown chunks are skipped   (glTF 2.0, "Binary glTF Layout"; G67)
/// err  glb-header, glb-chunk;  warning glb-extra-data
std::optional<Container> open_glb(std::span<const std::byte> file, IssueLog& log);

}  // namespace sinew
