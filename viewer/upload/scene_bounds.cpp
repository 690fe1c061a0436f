// SPDX-License-Identifier: MIT
#include "viewer/upload/scene_bounds.h"

#include "runtime/model/mesh_copies.h"

namespace sinew::viewer {

Aabb bounds_of(const Scene& scene, const FrameResult& frame) {
  Aabb box;
  for (std::size_t i = 0; i < frame.instances.size(); ++i) {
    const InstanceResult& instance = frame.instances[i];
    if (!instance.visible) continue;
    const Mesh& mesh = scene.meshes[scene.instances[i].mesh];
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      const DeformedPrimitive& deformed = frame.primitives[instance.first_primitive + p];
      const Primitive& primitive = mesh.primitives[p];
      const std::span<const glm::vec3> positions =
          deformed.positions.empty() ? primitive.positions : deformed.positions;
      for_each_copy(scene.instances[i], instance.world_from_mesh, [&](const Affine& world_from_copy) {
        for (const std::uint32_t v : primitive.indices) box.add(transform_point(world_from_copy, positions[v]));
      });
    }
  }
  return box;
}

}  // namespace sinew::viewer
