// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/plan/compiled_plan.h"

namespace sinew {

/// Plans what every primitive of every mesh instance goes through, and which skins that calls for.
/// in   plan    has its needs, assets, joint scales and stages of poses
///      beside  a plan of the same scene, whose tables of meshes are shared; may be null
/// out  plan    `primitives` to `instance_scales`; `palette`, `split` and `combined` of skins
/// cost O(influences + V log V), allocates. Internal to plan/
void plan_primitives(CompiledPlan& plan, const CompiledPlan* beside);

}  // namespace sinew
