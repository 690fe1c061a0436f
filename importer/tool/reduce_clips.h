// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <vector>

#include "runtime/compress/virtual_vertices.h"
#include "runtime/model/scene.h"

namespace sinew::tool {

/// Called before each clip: how far the work is.
using ClipProgress = std::function<void(double done_0_to_1)>;

/// The scene's animations without the keys that `budget_m` allows to leave out.
std::vector<Animation> reduced_animations(const Scene& scene, const VirtualVertices& vertices, double budget_m,
                                          const ClipProgress& progress);

/// Clips of animations that were reduced, written and read again, each measured against the animation that it came
/// from.
std::vector<Clip> certify_clips(const Scene& scene, const VirtualVertices& vertices,
                                const std::vector<Animation>& written, double budget_m);

}  // namespace sinew::tool
