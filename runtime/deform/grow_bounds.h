// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/math/affine.h"
#include "runtime/model/mesh.h"

namespace sinew {

/// Grows `bounds` to hold all points, moved by `world_from_mesh`.      cost O(V), no allocation
void grow_bounds(Aabb& bounds, std::span<const glm::vec3> points, const Affine& world_from_mesh) noexcept;

/// Grows `bounds` to hold a box, moved by `world_from_mesh`. Every point in the box stays inside to the last bit,
/// since rounding is monotonic and the corners are the extremes of each sum. An empty box adds nothing.
void grow_bounds(Aabb& bounds, const Aabb& box, const Affine& world_from_mesh) noexcept;

}  // namespace sinew
