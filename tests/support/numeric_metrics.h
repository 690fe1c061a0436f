// SPDX-License-Identifier: MIT
#pragma once
#include "tests/support/numeric_corpus.h"

namespace sinew::test {

/// Error of a result, in units of the case's `accept`: up to 1 is accepted. NaN, a missing number or an unknown metric
/// give infinity. Computed in double.
double numeric_miss(const Json& entry, const Outcome& got);

}  // namespace sinew::test
