// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/model/scene.h"

namespace sinew {

/// The part of check(Scene) that looks at animations, of some that are not yet in the scene.
ErrorCode check_animations(std::span<const Animation> animations, const Scene& scene) noexcept;

}  // namespace sinew
