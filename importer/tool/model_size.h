// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>

#include "importer/tool/length_text.h"
#include "runtime/model/scene.h"

namespace sinew::tool {

/// The size of a scene in which nothing has a place.
inline constexpr double kSizeWithoutVertices = 1e-9;

/// The box around all vertices of the rest pose, in world space, metres.
struct RestBox {
  std::array<double, 3> lower, upper;
};

/// out   nothing for a scene without vertices
std::optional<RestBox> rest_box(const Scene& scene);

/// The longest side of the box around all vertices of the rest pose, in world space: the scale of relative errors. A
/// scene without vertices has the size of the box around its joints at rest. If they rest at one place, it is the box
/// around them over all clips.
/// out   never 0; kSizeWithoutVertices if even that box has no size
double model_size_m(const Scene& scene);

/// A length in metres; the scene is looked at only where the length is a share of its size.
double metres_of(const Length& length, const Scene& scene);

}  // namespace sinew::tool
