// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/plan/compile_plan.h"

namespace sinew {

/// All stages that exist, in the order in which they run, each with the reason why this plan runs it or leaves it out.
std::vector<PlanStage> describe_stages(const Plan& plan);

}  // namespace sinew
