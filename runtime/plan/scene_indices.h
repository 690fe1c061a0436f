// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/model/scene.h"

namespace sinew {

/// True if all indices that compile_plan follows are in range, and parallel arrays of one length. check(Scene) proves
/// that too, among much else; this finds a scene that nobody checked before it is read out of bounds.
/// cost O(joints + instances + influences), no allocation. Internal to plan/
bool has_valid_indices(const Scene& scene) noexcept;

}  // namespace sinew
