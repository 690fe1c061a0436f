// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace sinew {

/// Escapes a name as a reference token of RFC 6901 ("~" and "/").
inline std::string pointer_token(std::string_view name) {
  std::string token;
  for (const char c : name) {
    if (c == '~')
      token += "~0";
    else if (c == '/')
      token += "~1";
    else
      token += c;
  }
  return token;
}

/// Joins parts to a JSON pointer: pointer("accessors", 3, "count") is "/accessors/3/count". Names are not escaped.
/// Parts that start with "/" are appended as they are.
template <class... Part>
std::string pointer(const Part&... part) {
  std::string text;
  const auto add = [&](const auto& p) {
    if constexpr (std::is_integral_v<std::remove_cvref_t<decltype(p)>>) {
      text += '/' + std::to_string(p);
    } else {
      const std::string_view name(p);
      if (name.empty() || name.front() != '/') text += '/';
      text += name;
    }
  };
  (add(part), ...);
  return text;
}

}  // namespace sinew
