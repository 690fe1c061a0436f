// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/model/scene_look.h"
#include "viewer/upload/upload_mesh.h"

namespace sinew::viewer {

/// Where the deformed attributes of a primitive lie in the slot's buffer; kAbsent = use the primitive's own.
struct DeformedBuffers {
  VkDeviceSize positions = kAbsent, normals = kAbsent, tangents = kAbsent, colors = kAbsent;
  std::uint64_t frame = 0;  ///< whose vertices these are
  glm::vec3 centre{0.0f};   ///< of the drawn vertices, mesh space: transparent draws are sorted by it
};

/// One mesh instance as it is drawn.
struct PlacedInstance {
  Affine world_from_mesh;
  bool mirrored = false, visible = true;
  bool hidden = false;                ///< not visible by its node's flag; else because it was said to be out of view
  Aabb bounds;                        ///< world space, of all its vertices; empty = not known
  std::uint32_t first_primitive = 0;  ///< into FrameVertices::primitives
};

/// What FrameUpload holds for one slot.
struct FrameVertices {
  Buffer buffer;
  std::vector<PlacedInstance> instances;
  std::vector<DeformedBuffers> primitives;
  std::vector<Affine> world_from_light;  ///< [lights of the scene]
  std::vector<bool> light_shines;        ///< [lights of the scene] it hangs on a node, which is shown
  SceneLook look;                        ///< materials, lights and cameras of this frame
  std::uint64_t frame = 0, source = 0;
  bool filled = false;
};

}  // namespace sinew::viewer
