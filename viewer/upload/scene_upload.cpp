// SPDX-License-Identifier: MIT
#include "viewer/upload/scene_upload.h"

#include "viewer/upload/scene_resources.h"

namespace sinew::viewer {

SceneUpload::SceneUpload(Device& device, const Scene& scene, std::uint32_t slot_count) {
  Staging staging(device);
  resources_ = std::make_unique<SceneResources>(device, scene, staging, slot_count);
  staging.send();
}

SceneUpload::~SceneUpload() = default;

void SceneUpload::update(std::uint32_t slot, const SceneLook& look) {
  resources_->materials.update(slot, look.materials);
}

const Scene& SceneUpload::scene() const noexcept { return resources_->scene; }

}  // namespace sinew::viewer
