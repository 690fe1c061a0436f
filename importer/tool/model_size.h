// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>

#include "importer/tool/length_text.h"
#include "runtime/model/scene.h"

namespace sinew::tool {

/// The size of a scene whose vertices and joints all lie at one point.
inline constexpr double kSizeWithoutVertices = 1e-9;

/// The box around all vertices of the rest pose, in world space, metres.
struct RestBox {
  std::array<double, 3> lower, upper;
};

/// The box of a scene; empty without vertices.
std::optional<RestBox> rest_box(const Scene& scene);

/// The longest side of the box around all vertices of the rest pose, in world space: the scale of relative errors. A
/// scene without vertices has the size of the box around its joints at rest. If they rest at one place, it is the box
/// around them over all clips.
/// out   never 0; kSizeWithoutVertices if even that box has no size
double model_size_m(const Scene& scene);

/// A length in metres. The scene is measured only if the length is a share of its size.
double metres_of(const Length& length, const Scene& scene);

}  // namespace sinew::tool
