// SPDX-License-Identifier: MIT
#pragma once
#include <functional>

#include "runtime/model/mesh.h"

namespace sinew::showcase {

/// The surface where `distance` is 0, in triangles: surface nets (Gibson 1998). One vertex in each cell that the
/// surface passes through, moved onto the surface, with the normal of the field.
/// in   distance  signed, negative inside; where it is more than `cell` it must not be far more than the distance to the
///                surface, since blocks of cells that lie farther away are passed over
/// out  closed where the solid lies inside of `bounds`
Primitive polygonise(const std::function<float(const glm::vec3&)>& distance, const Aabb& bounds, float cell);

}  // namespace sinew::showcase
