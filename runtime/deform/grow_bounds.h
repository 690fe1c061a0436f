// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/math/affine.h"
#include "runtime/model/mesh.h"

namespace sinew {

/// Makes `bounds` hold all points, moved by `world_from_mesh`.      cost O(V), no allocation
void grow_bounds(Aabb& bounds, std::span<const glm::vec3> points, const Affine& world_from_mesh) noexcept;

/// Makes `bounds` hold a box, moved by `world_from_mesh`: all points that the box holds stay inside, to the last bit,
/// since rounding keeps order and the corners are the extremes of each sum. An empty box adds nothing.
void grow_bounds(Aabb& bounds, const Aabb& box, const Affine& world_from_mesh) noexcept;

}  // namespace sinew
