// SPDX-License-Identifier: MIT
#pragma once
#include <functional>

#include "runtime/model/mesh.h"

namespace sinew::showcase {

/// Triangulates the surface where `distance` is 0 by surface nets (Gibson 1998). Each cell that the surface passes
/// through gives one vertex, moved onto the surface, with the normal of the field.
/// in   distance  signed, negative inside. Values above `cell` must not be far above the true distance, because blocks
///                of cells that seem farther away are skipped.
/// out  closed if the solid lies inside of `bounds`
Primitive polygonise(const std::function<float(const glm::vec3&)>& distance, const Aabb& bounds, float cell);

}  // namespace sinew::showcase
