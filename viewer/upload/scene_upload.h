// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/model/scene_look.h"
#include "viewer/upload/upload_materials.h"
#include "viewer/upload/upload_mesh.h"

namespace sinew::viewer {

/// GPU copies of the static parts of a scene: vertex attributes, indices, materials, mipmapped textures. A missing
/// image becomes a magenta and black checkerboard. The scene must outlive this object. Destroy it only when the GPU has
/// finished all frames that draw the scene.
/// cost copies all attributes and texels once; waits for the copies
class SceneUpload {
 public:
  /// in   slot_count  frames in flight: each has its own copy of animated materials
  ///      visibility      per-vertex ambient visibility, null = none; not used after the call
  SceneUpload(Device& device, const Scene& scene, std::uint32_t slot_count = 1,
              const VertexVisibility* visibility = nullptr, const TextureFilter& filter = {});

  /// Writes the animated materials of a frame into the slot.
  /// in   slot  the GPU must have finished its last use
  void update(std::uint32_t slot, const SceneLook& look) { materials_.update(slot, look.materials); }

  const Scene& scene() const noexcept { return scene_; }
  const MeshSet& meshes() const noexcept { return meshes_; }
  const MaterialSet& materials() const noexcept { return materials_; }
  const TextureFilter& filter() const noexcept { return filter_; }
  /// Different for every upload to a device.
  std::uint64_t number() const noexcept { return number_; }

 private:
  SceneUpload(Device& device, const Scene& scene, Staging staging, std::uint32_t slot_count,
              const VertexVisibility* visibility, const TextureFilter& filter);

  const Scene& scene_;
  MeshSet meshes_;
  MaterialSet materials_;
  TextureFilter filter_;
  std::uint64_t number_;
};

}  // namespace sinew::viewer
