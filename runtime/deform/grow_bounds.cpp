// SPDX-License-Identifier: MIT
#include "runtime/deform/grow_bounds.h"

#include <glm/common.hpp>

namespace sinew {

void grow_bounds(Aabb& bounds, std::span<const glm::vec3> points, const Affine& world_from_mesh) noexcept {
  Aabb grown = bounds;
  if (world_from_mesh == Affine{})
    for (const glm::vec3& p : points) grown.add(p);
  else
    for (const glm::vec3& p : points) grown.add(transform_point(world_from_mesh, p));
  bounds = grown;
}

void grow_bounds(Aabb& bounds, const Aabb& box, const Affine& world_from_mesh) noexcept {
  if (box.empty()) return;
  for (int corner = 0; corner < 8; ++corner)
    bounds.add(transform_point(world_from_mesh,
                               glm::vec3(corner & 1 ? box.upper.x : box.lower.x, corner & 2 ? box.upper.y : box.lower.y,
                                         corner & 4 ? box.upper.z : box.lower.z)));
}

}  // namespace sinew
