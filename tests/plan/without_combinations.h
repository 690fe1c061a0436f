// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/plan/compile_plan.h"

namespace sinew::test {

/// The plan with every vertex blending for itself (C06).
inline Plan without_combinations(Plan plan) {
  for (std::vector<CombinedInfluences>& of_skin : plan.combined) of_skin.clear();
  for (PrimitivePlan& primitive : plan.primitives) primitive.combined = kNone;
  return plan;
}

}  // namespace sinew::test
