// SPDX-License-Identifier: MIT
#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace sinew {

/// Whether no number is infinite or NaN. Looks at all of them without a branch, so that compilers make vector code of
/// it. cost O(n), memory-bound
inline bool all_finite(std::span<const float> numbers) noexcept {
  constexpr std::uint32_t kExponent = 0x7f800000u;
  std::uint32_t odd = 0;
  for (const float number : numbers) odd |= (std::bit_cast<std::uint32_t>(number) & kExponent) == kExponent ? 1u : 0u;
  return odd == 0;
}

/// The same for vectors of floats.
template <class Element>
bool all_finite(std::span<const Element> elements) noexcept {
  static_assert(sizeof(Element) % sizeof(float) == 0);
  return all_finite(
      std::span(reinterpret_cast<const float*>(elements.data()), elements.size() * (sizeof(Element) / sizeof(float))));
}

}  // namespace sinew
