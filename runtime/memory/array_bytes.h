// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "runtime/base/shared_array.h"

namespace sinew {

/// Bytes that strings and arrays hold beyond themselves; elements with arrays of their own count those by `of_each`.

inline std::size_t bytes_of(const std::string& text) noexcept {
  const bool is_inside = text.capacity() == std::string{}.capacity();
  return is_inside ? 0 : text.capacity() + 1;
}

template <class T>
std::size_t bytes_of(const std::vector<T>& array) noexcept {
  return array.capacity() * sizeof(T);
}
inline std::size_t bytes_of(const std::vector<bool>& array) noexcept { return array.capacity() / 8; }

/// What a shared array takes beside its elements: the vector, and the counts of those who share it.
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
