// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/model/scene.h"

namespace sinew {

/// True if all indices that compile_plan follows are in range, and parallel arrays have equal lengths. check(Scene)
/// proves this and much more. This check keeps compile_plan from reading out of bounds in a scene that nobody checked.
/// cost O(joints + instances + influences), no allocation. Internal to plan/
bool has_valid_indices(const Scene& scene) noexcept;

}  // namespace sinew
