// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/model/scene.h"
#include "runtime/plan/frame_result.h"

namespace sinew::viewer {

/// World-space box of everything that the frame draws, from the deformed vertices: a skinned mesh may be far from its
/// static box.
/// cost O(vertices); empty when the scene draws nothing
Aabb bounds_of(const Scene& scene, const FrameResult& frame);

}  // namespace sinew::viewer
