// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/model/scene.h"

namespace sinew {

/// Shows one of Scene::scenes: adds to `hidden_joints` all root joints that are neither roots of it nor above one.
/// Hidden joints are still evaluated, since skins may use them. Call it before plans are compiled.
/// in   index  into Scene::scenes; kNone = all roots are shown, nothing changes
/// cost O(J)
void show_scene(Scene& scene, std::uint32_t index);

}  // namespace sinew
