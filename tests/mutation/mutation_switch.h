// SPDX-License-Identifier: MIT
#pragma once

/// 0: the program runs as it was written; n: with mutant n; below 0: it notes which mutants each test reaches.
extern "C" int sinew_mutant;
extern "C" void sinew_mutant_is_reached(int number) noexcept;

/// True when mutant `number` was asked for by SINEW_MUTANT. Constant expressions are as they were written.
[[gnu::always_inline]] constexpr inline bool mutation_is(int number) noexcept {
  if (__builtin_is_constant_evaluated()) return false;
  if (sinew_mutant < 0) sinew_mutant_is_reached(number);
  return sinew_mutant == number;
}
