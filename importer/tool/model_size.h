// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>

#include "importer/tool/length_text.h"
#include "runtime/model/scene.h"

namespace sinew::tool {

inline constexpr double kSizeWithoutVertices = 1e-9;

/// The box around all vertices of the rest pose, in world space, metres.
struct RestBox {
  std::array<double, 3> lower, upper;
};

/// out   nothing for a scene without vertices
std::optional<RestBox> rest_box(const Scene& scene);

/// The longest side of the box around all vertices of the rest pose, in world space: the scale of relative errors.
/// out   never 0; kSizeWithoutVertices for a scene without vertices
double model_size_m(const Scene& scene);

/// A length in metres; the scene is looked at only where the length is a share of its size.
double metres_of(const Length& length, const Scene& scene);

}  // namespace sinew::tool
