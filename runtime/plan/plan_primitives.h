// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/plan/compiled_plan.h"

namespace sinew {

/// Decides the stages of every primitive of every mesh instance, and which skins these stages need.
/// in   plan    has its needs, assets, joint scales and stages of poses
///      beside  a plan of the same scene, whose tables of meshes are shared; may be null
/// out  plan    the members `primitives` to `instance_scales`; `palette`, `split` and `combined` of skins
/// cost O(influences + V log V), allocates. Internal to plan/
void plan_primitives(CompiledPlan& plan, const CompiledPlan* beside);

}  // namespace sinew
