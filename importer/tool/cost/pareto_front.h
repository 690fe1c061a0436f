// SPDX-License-Identifier: MIT
#pragma once
#include "importer/tool/cost/report.h"

namespace sinew::cost {

/// Sets Point::pareto of all points: true where no other point is at least as good in error and in cost, and better in
/// one of them; errors below Group::rounding count as equal. Of two points that are equal in both, both are on the
/// front. Points of another aim are neither on it nor beaten by it.
void mark_pareto_front(Group& group);

}  // namespace sinew::cost
