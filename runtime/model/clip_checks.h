// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/model/scene.h"

namespace sinew {

/// The part of check(Scene) for animations, here of ones that are not in the scene yet.
ErrorCode check_animations(std::span<const Animation> animations, const Scene& scene) noexcept;

}  // namespace sinew
