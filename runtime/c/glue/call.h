// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <new>
#include <type_traits>

#include "runtime/base/result.h"
#include "runtime/c/types.h"

// Shared by all C functions: checks pointers on entry, and turns exceptions and C++ codes into C codes on exit.

namespace sinew::c {

/// The codes of both sides are the same numbers (enums.h).
constexpr sinew_error error_from(ErrorCode code) noexcept { return static_cast<sinew_error>(code); }
constexpr sinew_error error_from(sinew_error code) noexcept { return code; }

/// An array, which may be null where it has no elements.
template <class T>
struct Array {
  const T* data;
  std::size_t count;
};
template <class T>
Array(const T*, std::size_t) -> Array<T>;

template <class T>
constexpr bool is_given(T* pointer) noexcept {
  return pointer != nullptr;
}
template <class T>
constexpr bool is_given(const Array<T>& array) noexcept {
  return array.data != nullptr || array.count == 0;
}

/// True if no pointer is null that must not be.
template <class... T>
constexpr bool given(const T&... pointers) noexcept {
  return (is_given(pointers) && ...);
}

/// A function of C: runs its body if its arguments are there.
/// in   body  returns a code of either side, or nothing. No exception leaves it
/// err  SINEW_NULL_ARGUMENT, SINEW_OUT_OF_MEMORY, those of the body
template <class Body>
sinew_error call(bool has_arguments, Body&& body) noexcept {
  if (!has_arguments) return SINEW_NULL_ARGUMENT;
  try {
    if constexpr (std::is_void_v<decltype(body())>) {
      body();
      return SINEW_OK;
    } else {
      return error_from(body());
    }
  } catch (const std::bad_alloc&) {
    return SINEW_OUT_OF_MEMORY;
  } catch (...) {
    return SINEW_UNSUPPORTED;
  }
}

}  // namespace sinew::c
