// SPDX-License-Identifier: MIT
#include "viewer/upload/scene_upload.h"

#include "viewer/upload/scene_resources.h"

namespace sinew::viewer {

SceneUpload::SceneUpload(Device& device, const Scene& scene) {
  Staging staging(device);
  resources_ = std::make_unique<SceneResources>(device, scene, staging);
  staging.send();
}

SceneUpload::~SceneUpload() = default;

const Scene& SceneUpload::scene() const noexcept { return resources_->scene; }

}  // namespace sinew::viewer
