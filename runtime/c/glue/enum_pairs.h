// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>

namespace sinew::c {

/// A value of an enumeration on both sides.
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

/// The one list of an enumeration, all values in their order. Does not compile where the numbers of a pair differ.
template <class Own, class OfC, std::size_t N>
consteval EnumValues<N> enum_values(const EnumPair<Own, OfC> (&pairs)[N]) {
  for (std::size_t i = 0; i < N; ++i)
    if (static_cast<std::size_t>(pairs[i].own) != i || static_cast<std::size_t>(pairs[i].of_c) != i)
      throw "a value has another number, or is not in its place";
  return {};
}

/// The list of an enumeration of C++ (enums.h). Without one it has no values to ask for.
struct NoEnumValues {};
template <class Own>
inline constexpr NoEnumValues kEnum{};

}  // namespace sinew::c
