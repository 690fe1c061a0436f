// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/model/scene.h"

namespace sinew::tool {

inline constexpr double kSizeWithoutVertices = 1e-9;

/// Largest side of the box around all vertices in the rest pose, world space: the scale for relative errors.
/// out  never 0: kSizeWithoutVertices for a scene without vertices
double model_size_m(const Scene& scene);

}  // namespace sinew::tool
