// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <span>

#include "importer/issue_log.h"

namespace sinew {

/// The two parts of a file: its JSON text and, in a .glb, the BIN chunk. Both point into the bytes of the file.
struct Container {
  std::span<const std::byte> json;
  std::optional<std::span<const std::byte>> bin;
};

/// True if the bytes start with "glTF".
bool looks_like_glb(std::span<const std::byte> file) noexcept;

/// Splits a .glb into its chunks. Checks every length against the real size before use. Skips unknown chunks.
/// eq       12 bytes header (magic, version, length), then chunks of 8 bytes header (length, type) and data: JSON
///          first, then at most one BIN   (glTF 2.0, "Binary glTF Layout")
/// err      glb-header, glb-chunk
/// warning  glb-alignment (a chunk whose length is no multiple of 4), glb-extra-data
std::optional<Container> open_glb(std::span<const std::byte> file, IssueLog& log);

}  // namespace sinew
