// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace sinew::tool {

/// A length of the command line: metres, or a share of the model's size.
struct Length {
  double metres = 0.0;
  double of_model = 0.0;  ///< 0.01 for 1%; `metres` is then 0
};

/// Ends the help of an option that takes a length.
inline constexpr const char* kLengthHelp =
    "such as 0.1mm, 0.01% (of the model's size) or 1e-4 (in the file's unit, which m stands for)";

/// Reads "0.1mm", "2 cm", "5um", "0.001m", a plain number of metres such as "1e-4", or "0.01%" of the model's size. If
/// a file is not in metres, its own unit takes the place of the metre.
/// err   a sentence for the user that says what is wrong and what would be right; negative and infinite lengths are
///       refused
tl::expected<Length, std::string> parse_length(std::string_view text);

/// Reads an angle such as "1deg", "0.02rad" or a plain number of degrees.
/// out   radians, 0 to pi
/// err   what is wrong, as a sentence for the user
tl::expected<double, std::string> parse_angle(std::string_view text);

/// Reads a number that is not negative, or a percentage of 1: "0.001", "0.1%".
/// err   what is wrong, as a sentence for the user
tl::expected<double, std::string> parse_ratio(std::string_view text);

/// "0.1 mm": three digits, with the unit that makes the number readable.
std::string length_text(double metres);

}  // namespace sinew::tool
