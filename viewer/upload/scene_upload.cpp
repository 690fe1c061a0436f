// SPDX-License-Identifier: MIT
#include "viewer/upload/scene_upload.h"

namespace sinew::viewer {

SceneUpload::SceneUpload(Device& device, const Scene& scene, std::uint32_t slot_count,
                         const VertexVisibility* visibility, const TextureFilter& filter)
    : SceneUpload(device, scene, Staging(device), slot_count, visibility, filter) {}

SceneUpload::SceneUpload(Device& device, const Scene& scene, Staging staging, std::uint32_t slot_count,
                         const VertexVisibility* visibility, const TextureFilter& filter)
    : scene_(scene),
      meshes_(device, scene, visibility, staging),
      materials_(device, scene, staging, slot_count, filter),
      filter_(filter),
      number_(device.next_number()) {
  staging.send();
}

}  // namespace sinew::viewer
