// SPDX-License-Identifier: MIT
#include "runtime/halves.h"

int half_of_int(int x) { return half(x); }

bool is_small(double x) {
  if (x < 1.0) return true;
  return false;
}
