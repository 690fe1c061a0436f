// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>

namespace sinew::c {

/// One value of an enumeration, in C++ and in C.
template <class Own, class OfC>
struct EnumPair {
  Own own;
  OfC of_c;
};

/// An enumeration whose values have the same numbers in C++ and C: 0 to N - 1.
template <std::size_t N>
struct EnumValues {
  /// True for numbers of C that are a value.
  constexpr bool has(std::uint32_t number) const noexcept { return number < N; }
};

/// Lists all values of an enumeration in order. It compiles only if both numbers of each pair are its position in the
/// list.
template <class Own, class OfC, std::size_t N>
consteval EnumValues<N> enum_values(const EnumPair<Own, OfC> (&pairs)[N]) {
  for (std::size_t i = 0; i < N; ++i)
    if (static_cast<std::size_t>(pairs[i].own) != i || static_cast<std::size_t>(pairs[i].of_c) != i)
      throw "a value has another number, or is not in its place";
  return {};
}

/// The list of values of a C++ enumeration; enums.h defines it. An enumeration without a list has no function has().
struct NoEnumValues {};
template <class Own>
inline constexpr NoEnumValues kEnum{};

}  // namespace sinew::c
