// SPDX-License-Identifier: MIT
#include "runtime/model/show_scene.h"

#include <vector>

namespace sinew {

void show_scene(Scene& scene, std::uint32_t index) {
  if (index == kNone) return;
  const std::vector<std::uint32_t>& parents = scene.skeleton.parents;
  std::vector<bool> shown(parents.size(), false);  // or already hidden
  for (const std::uint32_t joint : scene.hidden_joints) shown[joint] = true;
  for (std::uint32_t joint : scene.scenes[index].joints) {
    while (parents[joint] != kNone) joint = parents[joint];
    shown[joint] = true;
  }
  for (std::uint32_t joint = 0; joint < parents.size(); ++joint)
    if (parents[joint] == kNone && !shown[joint]) scene.hidden_joints.push_back(joint);
}

}  // namespace sinew
