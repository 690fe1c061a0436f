// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sinew {

/// Decodes base64 (RFC 4648, section 4), 16 characters at once. Padding is optional; bits beyond the last whole byte
/// are ignored.
/// out   empty if a character is not in the alphabet, or a single character is left over
/// cost  O(text); allocates 3/4 of its size
std::optional<std::vector<std::byte>> decode_base64(std::string_view text);

/// Encodes bytes as base64, with padding.
std::string encode_base64(std::string_view bytes);

}  // namespace sinew
