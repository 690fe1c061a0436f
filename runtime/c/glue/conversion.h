// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstring>
#include <type_traits>

#include "runtime/c/types.h"

// Conversion between types of C and types of C++. The general rules are in convert.h. A rule that only some functions
// need is beside these functions.

namespace sinew::c {

/// The rule for a type of C and a type of C++. Specialisations have:
///     static sinew_error read(const OfC& given, Own& own) noexcept;    // from C
///     static void write(const Own& own, OfC& out) noexcept;            // to C; strings and spans are views
template <class OfC, class Own>
struct Convert;

/// True for pairs whose objects are the same bytes. Files that know both types specialise it.
template <class OfC, class Own>
inline constexpr bool kSameBytes = std::is_same_v<OfC, Own>;

/// Copies the bytes of a struct to one of another type with the same content.
template <class From, class To>
void copy_bytes(const From& from, To& to) noexcept {
  static_assert(std::is_trivially_copyable_v<From> && std::is_trivially_copyable_v<To>);
  std::memcpy(static_cast<void*>(&to), &from, std::min(sizeof(From), sizeof(To)));
}

template <class OfC, class Own>
requires kSameBytes<OfC, Own>
struct Convert<OfC, Own> {
  static_assert(sizeof(OfC) == sizeof(Own) && alignof(OfC) == alignof(Own));
  static sinew_error read(const OfC& given, Own& own) noexcept {
    copy_bytes(given, own);
    return SINEW_OK;
  }
  static void write(const Own& own, OfC& out) noexcept { copy_bytes(own, out); }
};

/// Rule for a C++ value that is stored in an opaque C struct, which may be larger.
template <class OfC, class Own>
struct ConvertInside {
  static_assert(sizeof(Own) <= sizeof(OfC) && alignof(Own) <= alignof(OfC));
  static sinew_error read(const OfC& given, Own& own) noexcept {
    copy_bytes(given, own);
    return SINEW_OK;
  }
  static void write(const Own& own, OfC& out) noexcept {
    out = {};
    copy_bytes(own, out);
  }
};

/// Wraps a C++ object, so that it converts to any C type that has a rule for it.
template <class Own>
struct ToC {
  const Own& own;

  template <class OfC>
  operator OfC() const noexcept {
    OfC out{};
    Convert<OfC, Own>::write(own, out);
    return out;
  }
};

/// For the fields of a struct of C: `.positions = to_c(shape.positions)`.
template <class Own>
ToC<Own> to_c(const Own& own) noexcept {
  return {own};
}

/// Converts a C value to C++.     err  that of the rule
template <class OfC, class Own>
sinew_error from_c(const OfC& given, Own& own) {
  return Convert<OfC, Own>::read(given, own);
}

}  // namespace sinew::c
