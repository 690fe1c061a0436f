// SPDX-License-Identifier: MIT
#pragma once
#include "tests/support/numeric_corpus.h"

namespace sinew::test {

/// How far an outcome is from the truth of a case, in units of what the case's `accept` allows: at most 1 is accepted,
/// infinity for NaN, a missing number or an unknown metric. Formed in double; each metric is written once, in the .cpp.
double numeric_miss(const Json& entry, const Outcome& got);

}  // namespace sinew::test
