// SPDX-License-Identifier: MIT
#pragma once

/// What stands between `low` and `high` and is nearest to `value`.
int clamped(int value, int low, int high);

int tripled(int x);

/// How many of three numbers are the value; an index behind its end must not pass unnoticed.
int count_in_three(int value);

/// The sum of the first `count` numbers; nothing calls it.
int sum(const int* numbers, int count);

/// Twice the distance of two numbers, from the header, so that each file that includes it has its own.
inline int twice_apart(int a, int b) { return 2 * (a < b ? b - a : a - b); }
