// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/model/scene.h"
#include "runtime/plan/needs.h"
#include "runtime/plan/refusal.h"

namespace sinew {

/// Finds the first rule that needs break for a scene. Use it for needs that come from a file or a script, since
/// compile_plan breaks a contract for bad needs.
/// out  Refusal::field  the member, such as "in.masks"
/// err  unsupported (in.max_layers is 0; more masks, or more room for programs, than programs can use)
///      not_finite (a weight of in.masks is NaN, infinite or below 0)
///      index_out_of_range (in.cached_instances do not exist or do not rise)
///      size_mismatch (in.masks, in.mirror, out.skeleton_lod or skin.per_instance of another scene)
/// cost O(masks * joints), no allocation
SINEW_API Refusal find_fault(const Needs& needs, const Scene& scene) noexcept;

/// True if the clip moves as many joints, morph weights and properties as the scene has.
SINEW_API bool fits(const Clip& clip, const Scene& scene) noexcept;

}  // namespace sinew
