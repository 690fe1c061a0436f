// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <new>
#include <type_traits>

#include "runtime/base/result.h"
#include "runtime/c/types.h"

// Used by all C functions: checks pointers on entry, and turns exceptions and C++ error codes into C codes on exit.

namespace sinew::c {

/// C and C++ use the same numbers for error codes (enums.h).
constexpr sinew_error error_from(ErrorCode code) noexcept { return static_cast<sinew_error>(code); }
constexpr sinew_error error_from(sinew_error code) noexcept { return code; }

/// An array argument. It may be null if it has no elements.
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

/// True if none of the arguments is null that must not be null.
template <class... T>
constexpr bool given(const T&... pointers) noexcept {
  return (is_given(pointers) && ...);
}

/// Runs the body of a C function if its arguments are given.
/// in   body  returns an error code of C or C++, or nothing; its exceptions become error codes
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
