// SPDX-License-Identifier: MIT
#include "viewer/upload/scene_upload.h"

namespace sinew::viewer {

SceneUpload::SceneUpload(Device& device, const Scene& scene, std::uint32_t slot_count)
    : SceneUpload(device, scene, Staging(device), slot_count) {}

SceneUpload::SceneUpload(Device& device, const Scene& scene, Staging staging, std::uint32_t slot_count)
    : scene_(scene), meshes_(device, scene, staging), materials_(device, scene, staging, slot_count) {
  staging.send();
}

}  // namespace sinew::viewer
