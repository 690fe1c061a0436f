// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

namespace sinew {

/// Makes text from a file safe to print on a terminal. Escapes control characters ("\x1b", "\u009b"), characters that
/// change the text direction, and bytes that are not UTF-8.
std::string visible_text(std::string_view text);

/// Likewise for JSON text, whose writers escape only characters below 32. Escapes are valid inside JSON strings, such
/// as "\u009b".
/// in   JSON in UTF-8
std::string visible_json(std::string_view json);

/// True if all bytes are UTF-8 (RFC 3629): shortest forms, no surrogates.
bool is_utf8(std::string_view text) noexcept;

}  // namespace sinew
