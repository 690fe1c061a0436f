// SPDX-License-Identifier: MIT
#pragma once
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

namespace sinew {

/// True if no number is infinite or NaN. The loop has no branch, so compilers vectorise it.
/// cost O(n), memory-bound
template <std::floating_point T>
bool all_finite(std::span<const T> numbers) noexcept {
  using Bits = std::conditional_t<sizeof(T) == sizeof(float), std::uint32_t, std::uint64_t>;
  constexpr Bits kExponent = std::bit_cast<Bits>(std::numeric_limits<T>::infinity());
  Bits odd = 0;
  for (const T number : numbers) odd |= (std::bit_cast<Bits>(number) & kExponent) == kExponent ? Bits{1} : Bits{0};
  return odd == 0;
}

/// As above, for vectors, quaternions and matrices of floats.
template <class Element>
bool all_finite(std::span<const Element> elements) noexcept {
  static_assert(sizeof(Element) % sizeof(float) == 0);
  return all_finite(std::span<const float>(reinterpret_cast<const float*>(elements.data()),
                                           elements.size() * (sizeof(Element) / sizeof(float))));
}

template <class Element>
bool all_finite(const std::vector<Element>& elements) noexcept {
  return all_finite(std::span<const Element>(elements));
}

}  // namespace sinew
