// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "runtime/model/scene_look.h"
#include "viewer/device/device.h"

namespace sinew::viewer {

struct SceneResources;  // scene_resources.h: for the passes

/// The parts of a scene that no clip deforms, on the GPU: vertex attributes, indices, materials, textures with mipmaps.
/// A missing image becomes a magenta and black checkerboard (G66). Keeps a pointer to the scene, which must outlive it.
/// cost copies all attributes and pixels once; waits until they have arrived
class SceneUpload {
 public:
  /// in   slot_count  frames in flight: materials that clips move are kept once for each
  SceneUpload(Device& device, const Scene& scene, std::uint32_t slot_count = 1);
  ~SceneUpload();  ///< the GPU must be done with all frames that drew it
  SceneUpload(const SceneUpload&) = delete;
  SceneUpload& operator=(const SceneUpload&) = delete;

  const Scene& scene() const noexcept;

  /// Puts the materials of a frame's look into the slot.
  /// in   slot  the GPU must be done with its last use
  void update(std::uint32_t slot, const SceneLook& look);
  const SceneResources& resources() const noexcept { return *resources_; }

 private:
  std::unique_ptr<SceneResources> resources_;
};

}  // namespace sinew::viewer
