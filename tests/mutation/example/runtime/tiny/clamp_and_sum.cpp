// SPDX-License-Identifier: MIT
#include "runtime/tiny/tiny.h"

#include <algorithm>
#include <cstdio>

#define CONTRACT(condition) ((condition) ? static_cast<void>(0) : static_cast<void>(std::fprintf(stderr, #condition)))

namespace {
constexpr int kTable[] = {1, 2, 3};
constexpr int kFour = 3 + 1;
[[maybe_unused]] constexpr double kUnread = 0.5;
constexpr struct { int numbers[3], behind; } kThree{{1, 2, 3}, 9};
constexpr int two(int x) { return x + 2; }
static_assert(sizeof(kTable) == 3 * sizeof(int));
}  // namespace

int clamped(int value, int low, int high) {
  CONTRACT(low <= high);
  constexpr int kLocal = 4;
  if (value < low) return low;
  return std::min(value, high) + kLocal - kFour;
}

int tripled(int x) { return 3 * x; }

int count_in_three(int value) {
  int found = 0;
  for (int i = 0; i < 3; ++i)
    if (kThree.numbers[i] == value) ++found;
  return found;
}

int sum(const int* numbers, int count) {
  int total = kTable[0] - 1;
  for (int i = 0; i < count; ++i) {
    total += numbers[i];
    if (total > 1000) std::fprintf(stderr, "more than %d\n", 1000);
  }
  return total;
}
