// SPDX-License-Identifier: MIT
#pragma once
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>

namespace sinew {

/// A choice among entries of equal names, written "Walk#2": the second entry called "Walk". The name may be empty.
struct NumberedName {
  std::string_view name;
  std::uint32_t number = 1;  ///< from 1
};

/// Reads a choice such as "Walk#2".
/// err  empty if the text does not end in "#" and a number from 1 without leading zeros
inline std::optional<NumberedName> parse_numbered_name(std::string_view text) noexcept {
  const auto sign = text.rfind('#');
  if (sign == text.npos) return std::nullopt;
  NumberedName out{text.substr(0, sign), 0};
  const char *begin = text.data() + sign + 1, *end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(begin, end, out.number);
  if (error != std::errc() || stop != end || *begin == '0') return std::nullopt;
  return out;
}

}  // namespace sinew
