// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/api.h"
#include "runtime/math/affine.h"
#include "runtime/model/mesh.h"

namespace sinew {

/// Grows `bounds` to contain all points, moved by `world_from_mesh`.      cost O(V), no allocation
SINEW_API void grow_bounds(Aabb& bounds, std::span<const glm::vec3> points, const Affine& world_from_mesh) noexcept;

/// Grows `bounds` to contain a box, moved by `world_from_mesh`. An empty box adds nothing. Every point of the box stays
/// inside even after rounding: rounding is monotonic, and corners are the extremes of each sum.
SINEW_API void grow_bounds(Aabb& bounds, const Aabb& box, const Affine& world_from_mesh) noexcept;

}  // namespace sinew
