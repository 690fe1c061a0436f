// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/upload/upload_materials.h"
#include "viewer/upload/upload_mesh.h"

namespace sinew::viewer {

/// What SceneUpload holds; members in the order of their upload.
struct SceneResources {
  SceneResources(Device& device, const Scene& uploaded, Staging& staging, std::uint32_t slot_count)
      : scene(uploaded), meshes(device, uploaded, staging), materials(device, uploaded, staging, slot_count) {}

  const Scene& scene;
  MeshSet meshes;
  MaterialSet materials;
};

}  // namespace sinew::viewer
