// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace sinew::tool {

/// Reads "0.1mm", "2 cm", "5um", "0.001m", or a plain number of metres such as "1e-4". For a file that is not in metres
/// its own unit takes the place of the metre.
/// err   a sentence that says what is wrong and what would be right; negative and infinite lengths are refused
tl::expected<double, std::string> parse_length(std::string_view text);

/// "0.1 mm": three digits, with the unit that makes the number readable.
std::string length_text(double metres);

}  // namespace sinew::tool
