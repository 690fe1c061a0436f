// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/model/scene.h"

namespace sinew::tool {

inline constexpr double kSizeWithoutVertices = 1e-9;

/// The longest side of the box around all vertices of the rest pose, in world space: the scale of relative errors.
/// out   never 0; kSizeWithoutVertices for a scene without vertices
double model_size_m(const Scene& scene);

}  // namespace sinew::tool
