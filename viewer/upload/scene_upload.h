// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "runtime/assets/scene.h"
#include "viewer/device/device.h"

namespace sinew::viewer {

struct SceneResources;  // scene_resources.h: for the passes

/// The parts of a scene that never change, on the GPU: vertex attributes, indices, materials, textures with mipmaps.
/// A missing image becomes a magenta and black checkerboard (G66). Keeps a pointer to the scene, which must outlive it.
/// cost copies all attributes and pixels once; waits until they have arrived
class SceneUpload {
 public:
  SceneUpload(Device& device, const Scene& scene);
  ~SceneUpload();  ///< the GPU must be done with all frames that drew it
  SceneUpload(const SceneUpload&) = delete;
  SceneUpload& operator=(const SceneUpload&) = delete;

  const Scene& scene() const noexcept;
  const SceneResources& resources() const noexcept { return *resources_; }

 private:
  std::unique_ptr<SceneResources> resources_;
};

}  // namespace sinew::viewer
