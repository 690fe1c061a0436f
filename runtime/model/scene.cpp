// SPDX-License-Identifier: MIT
#include "runtime/model/scene.h"

#include <algorithm>

#include "runtime/clip/clip_rest.h"
#include "runtime/model/scene_look.h"

namespace sinew {

std::optional<std::uint32_t> find_clip(const Scene& scene, std::string_view name) noexcept {
  const auto found =
      std::find_if(scene.clips.begin(), scene.clips.end(), [&](const Clip& clip) { return clip.name() == name; });
  if (found == scene.clips.end()) return std::nullopt;
  return static_cast<std::uint32_t>(found - scene.clips.begin());
}

std::vector<float> rest_weights_of(const Scene& scene) {
  std::vector<float> weights;
  for (const MeshInstance& instance : scene.instances)
    weights.insert(weights.end(), instance.rest_weights.begin(), instance.rest_weights.end());
  return weights;
}

void finish_scene(Scene& scene) {
  scene.first_weight.assign(1, 0);
  for (const MeshInstance& instance : scene.instances)
    scene.first_weight.push_back(scene.first_weight.back() + static_cast<std::uint32_t>(instance.rest_weights.size()));
  const std::vector<float> rest_weights = rest_weights_of(scene);
  scene.properties = make_property_table(scene);
  for (Mesh& mesh : scene.meshes)
    for (Primitive& primitive : mesh.primitives)
      if (primitive.bounds.empty())
        for (const glm::vec3& position : primitive.positions) primitive.bounds.add(position);
  scene.clips.clear();
  scene.clips.reserve(scene.animations.size());
  const ClipRest rest = clip_rest(scene.skeleton, rest_weights, scene.properties);
  for (const Animation& animation : scene.animations)
    scene.clips.push_back(compile_clip(animation, rest, scene.first_weight, scene.properties));
}

void show_scene(Scene& scene, std::uint32_t index) {
  if (index == kNone) return;
  const std::vector<std::uint32_t>& parents = scene.skeleton.parents;
  std::vector<bool> shown(parents.size(), false);
  for (const std::uint32_t joint : scene.hidden_joints) shown[joint] = true;  // these need not be hidden again
  for (std::uint32_t joint : scene.scenes[index].joints) {
    while (parents[joint] != kNone) joint = parents[joint];
    shown[joint] = true;
  }
  for (std::uint32_t joint = 0; joint < parents.size(); ++joint)
    if (parents[joint] == kNone && !shown[joint]) scene.hidden_joints.push_back(joint);
}

}  // namespace sinew
