// SPDX-License-Identifier: MIT
#pragma once

/// 0: no mutant is active; n: mutant n is active; below 0: no mutant is active, and the program records which ones each
/// test reaches.
extern "C" int sinew_mutant;
extern "C" void sinew_mutant_is_reached(int number) noexcept;

/// True if the environment variable SINEW_MUTANT names this mutant. Constant expressions are never mutated.
[[gnu::always_inline]] constexpr inline bool mutation_is(int number) noexcept {
  if (__builtin_is_constant_evaluated()) return false;
  if (sinew_mutant < 0) sinew_mutant_is_reached(number);
  return sinew_mutant == number;
}
