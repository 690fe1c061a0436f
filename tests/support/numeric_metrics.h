// SPDX-License-Identifier: MIT
#pragma once
#include "tests/support/numeric_corpus.h"

namespace sinew::test {

/// Distance of an outcome from the truth of a case, in units of the case's `accept`: up to 1 is accepted; NaN, a
/// missing number or an unknown metric give infinity. Computed in double. Each metric is written once, in the .cpp.
double numeric_miss(const Json& entry, const Outcome& got);

}  // namespace sinew::test
