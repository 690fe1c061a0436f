// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace sinew::tool {

/// Reads "0.1mm", "2 cm", "5um", "0.001m" or a plain number of metres such as "1e-4". Files that are not in metres have
/// their own unit in place of the metre. err  a sentence that says what is wrong and what would be right; negative and
/// infinite lengths are refused
tl::expected<double, std::string> parse_length(std::string_view text);

/// "0.1 mm", with the unit that makes it readable and three digits.
std::string length_text(double metres);

}  // namespace sinew::tool
