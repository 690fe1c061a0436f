// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "runtime/base/shared_array.h"

namespace sinew {

/// Heap bytes of strings and arrays, without the object itself. `of_each(element)` adds the heap bytes of elements.

inline std::size_t bytes_of(const std::string& text) noexcept {
  const bool is_inside = text.capacity() == std::string{}.capacity();
  return is_inside ? 0 : text.capacity() + 1;
}

template <class T>
std::size_t bytes_of(const std::vector<T>& array) noexcept {
  return array.capacity() * sizeof(T);
}
inline std::size_t bytes_of(const std::vector<bool>& array) noexcept { return array.capacity() / 8; }

/// Heap bytes of a SharedArray besides its elements: the vector and the reference counts.
inline constexpr std::size_t kSharedArrayBytes = sizeof(std::vector<int>) + 2 * sizeof(void*);

template <class T>
std::size_t bytes_of(const SharedArray<T>& array) noexcept {
  return array.empty() ? 0 : array.size() * sizeof(T) + kSharedArrayBytes;
}

template <class Array, class OfEach>
std::size_t bytes_of(const Array& array, const OfEach& of_each) {
  std::size_t bytes = bytes_of(array);
  for (const auto& element : array) bytes += of_each(element);
  return bytes;
}

template <class Array>
std::size_t bytes_of_texts(const Array& texts) {
  return bytes_of(texts, [](const std::string& text) { return bytes_of(text); });
}

}  // namespace sinew
