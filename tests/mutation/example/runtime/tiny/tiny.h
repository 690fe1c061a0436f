// SPDX-License-Identifier: MIT
#pragma once

/// `value`, limited to the range from `low` to `high`.
int clamped(int value, int low, int high);

int tripled(int x);

/// Counts how many of three numbers equal the value. A mutant that reads an index behind their end must be noticed.
int count_in_three(int value);

/// The sum of the first `count` numbers; no test calls it.
int sum(const int* numbers, int count);

/// Twice the distance of two numbers. It is inline, so each file that includes this header has its own copy.
inline int twice_apart(int a, int b) { return 2 * (a < b ? b - a : a - b); }
