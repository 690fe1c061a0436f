// SPDX-License-Identifier: MIT
// Plays the tests: it halves a positive int and a negative float, and asks once what is small.
#include "runtime/halves.h"

int half_of_int(int x);
bool is_small(double x);

int main() {
  try {
    half(-1.0f);
  } catch (const std::range_error&) {
  }
  return half_of_int(4) == 2 && is_small(0.5) ? 0 : 1;
}
