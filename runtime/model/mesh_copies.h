// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/math/quaternion.h"
#include "runtime/math/transform.h"
#include "runtime/model/scene.h"

namespace sinew {

/// Calls `use(world_from_copy)` for every copy of an instance; once, with `world_from_mesh`, if it has no copies.
/// in   world_from_mesh   InstanceResult::world_from_mesh; products are computed in its precision T
template <class T, class Use>
void for_each_copy(const MeshInstance& instance, const AffineT<T>& world_from_mesh, Use&& use) {
  if (instance.copies.empty()) return use(world_from_mesh);
  for (const Transform& copy : instance.copies)
    use(world_from_mesh * affine_from_transform(TransformT<T>{Vec3<T>(copy.translation), quat_cast<T>(copy.rotation),
                                                              Vec3<T>(copy.scale)}));
}

}  // namespace sinew
