// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

namespace sinew {

/// Text from a file as a terminal may show it: terminals obey control characters. They are written as escapes ("\x1b",
/// "\u009b"), as are those that turn the direction of text and bytes that are no UTF-8.
std::string visible_text(std::string_view text);

/// The same for JSON text, whose writers escape only the characters below 32: "\u009b" inside its strings.
/// in   JSON in UTF-8
std::string visible_json(std::string_view json);

}  // namespace sinew
