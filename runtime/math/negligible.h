// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/conventions.h"

namespace sinew {

/// Weights and displacements below this count as zero. They are invisible, but their products are denormal numbers, on
/// which some processors are a hundred times slower.
inline constexpr float kNegligible = 1e-20f;

/// 0 where |x| < 1e-20, else x.
template <class T>
constexpr T flushed(T x) noexcept {
  return (x < T(0) ? -x : x) < T(kNegligible) ? T(0) : x;
}

/// As above, for each component.
template <glm::length_t L, class T>
glm::vec<L, T, glm::defaultp> flushed(glm::vec<L, T, glm::defaultp> v) noexcept {
  for (glm::length_t i = 0; i < L; ++i) v[i] = flushed(v[i]);
  return v;
}

}  // namespace sinew
