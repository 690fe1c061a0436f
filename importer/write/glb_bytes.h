// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace sinew::write {

/// The bytes of a .glb with these chunks; omits the BIN chunk if `bin` is empty.
/// eq    12 bytes header (magic, version, length), JSON chunk padded with spaces, BIN chunk padded with zeros (glTF
///       2.0, "Binary glTF Layout")
/// out   empty if the file would have 4 GiB or more: its lengths have 32 bits
std::optional<std::vector<std::byte>> glb_bytes(std::string_view json, std::span<const std::byte> bin);

}  // namespace sinew::write
