// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/model/scene.h"

namespace sinew {

/// Hides what one of Scene::scenes does not hold: root joints that are neither among its roots nor above one of them
/// join `hidden_joints`. They are evaluated all the same, since skins may hang on them (G32). Do it before plans are
/// compiled.
/// in   index  of the scene; kNone = all roots are shown, and nothing changes
/// cost O(J)
void show_scene(Scene& scene, std::uint32_t index);

}  // namespace sinew
