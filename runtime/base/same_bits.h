// SPDX-License-Identifier: MIT
#pragma once
#include <cstring>
#include <span>

namespace sinew {

/// True if two arrays have the same bits. Unlike ==, 0 and -0 differ, and a NaN equals itself.
/// in   a, b  elements of a type made of numbers, without padding
template <class T>
bool same_bits(std::span<const T> a, std::span<const T> b) noexcept {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

template <class T>
bool same_bits(const T& a, const T& b) noexcept {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

}  // namespace sinew
