// SPDX-License-Identifier: MIT
#include "viewer/upload/scene_upload.h"

namespace sinew::viewer {

SceneUpload::SceneUpload(Device& device, const Scene& scene, std::uint32_t slot_count, const VertexAccess* access)
    : SceneUpload(device, scene, Staging(device), slot_count, access) {}

SceneUpload::SceneUpload(Device& device, const Scene& scene, Staging staging, std::uint32_t slot_count,
                         const VertexAccess* access)
    : scene_(scene), meshes_(device, scene, access, staging), materials_(device, scene, staging, slot_count) {
  staging.send();
}

}  // namespace sinew::viewer
