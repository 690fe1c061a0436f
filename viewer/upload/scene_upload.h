// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/model/scene_look.h"
#include "viewer/upload/upload_materials.h"
#include "viewer/upload/upload_mesh.h"

namespace sinew::viewer {

/// The parts of a scene that no clip deforms, on the GPU: vertex attributes, indices, materials, textures with mipmaps.
/// A checkerboard of magenta and black stands in for a missing image (G66). Keeps a pointer to the scene, which must
/// outlive it. The GPU must be done with all frames that drew the scene before it is destroyed.
/// cost copies all attributes and pixels once; waits until they have arrived
class SceneUpload {
 public:
  /// in   slot_count  frames in flight: each has its own copy of the materials that clips animate
  ///      access      ambient access of the vertices, null = none; not read after the call
  SceneUpload(Device& device, const Scene& scene, std::uint32_t slot_count = 1, const VertexAccess* access = nullptr,
              const TextureFilter& filter = {});

  /// Writes the materials of a frame into the slot.
  /// in   slot  the GPU must be done with its last use
  void update(std::uint32_t slot, const SceneLook& look) { materials_.update(slot, look.materials); }

  const Scene& scene() const noexcept { return scene_; }
  const MeshSet& meshes() const noexcept { return meshes_; }
  const MaterialSet& materials() const noexcept { return materials_; }
  const TextureFilter& filter() const noexcept { return filter_; }

 private:
  SceneUpload(Device& device, const Scene& scene, Staging staging, std::uint32_t slot_count, const VertexAccess* access,
              const TextureFilter& filter);

  const Scene& scene_;
  MeshSet meshes_;
  MaterialSet materials_;
  TextureFilter filter_;
};

}  // namespace sinew::viewer
