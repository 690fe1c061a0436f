// SPDX-License-Identifier: MIT
#include "importer/rewrite/add_animations.h"

#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "importer/read/annotations.h"
#include "importer/read/property_pointer.h"
#include "importer/rewrite/key_writer.h"

namespace sinew::rewrite {
namespace {

/// True if a matrix equals a transform within rounding: no column deviates by more than kRounding of its length. Both
/// have the same translation.
bool is_matrix_of(const Affine& matrix, const Transform& transform) {
  constexpr float kRounding = 1e-4f;
  const glm::mat3 given = linear_part(matrix), made = linear_part(affine_from_transform(transform));
  for (int column = 0; column < 3; ++column)
    if (glm::length(given[column] - made[column]) > kRounding * glm::length(given[column])) return false;
  return true;
}

void take_apart(const Scene& scene, std::uint32_t joint, Draft& draft) {
  const Skeleton& skeleton = scene.skeleton;
  const std::uint32_t node = skeleton.node_of_joint[joint], fixed = skeleton.fixed_matrix_of[joint];
  Json& entry = draft.json["nodes"][node];
  if (fixed == kNone || entry.erase("matrix") == 0) return;
  const Transform& rest = skeleton.rest[joint];
  const auto list = [](const glm::vec3& v) { return Json{v.x, v.y, v.z}; };
  entry["translation"] = list(rest.translation);
  entry["rotation"] = Json{rest.rotation.x, rest.rotation.y, rest.rotation.z, rest.rotation.w};
  entry["scale"] = list(rest.scale);
  if (!is_matrix_of(skeleton.fixed_matrices[fixed], rest))
    draft.losses.push_back({"node-matrix-animated", "/nodes/" + std::to_string(node) + "/matrix",
                            "is animated now, and shears: no translation, rotation and scale say the same"});
}

/// Makes an animation object. If it has no channels, adds one without a node, because glTF requires one.
Json animation_of(const Scene& scene, const Animation& animation, Draft& draft) {
  Json out{{"channels", Json::array()}, {"samplers", Json::array()}};
  if (!animation.name.empty()) out["name"] = animation.name;
  set_annotations(animation.annotations, out);
  KeyWriter writer(draft);
  const auto add = [&](const std::optional<Keys>& keys, Json target) {
    if (!keys) return;
    Json sampler = Json::object();
    writer.write(*keys, sampler);
    out["channels"].push_back({{"sampler", out["samplers"].size()}, {"target", std::move(target)}});
    out["samplers"].push_back(std::move(sampler));
  };
  for (const BoneAnimation& bone : animation.bones) {
    take_apart(scene, bone.joint, draft);
    const auto target = [&](const char* path) {
      return Json{{"node", scene.skeleton.node_of_joint[bone.joint]}, {"path", path}};
    };
    add(keys_of(bone.translation), target("translation"));
    add(keys_of(bone.rotation), target("rotation"));
    add(keys_of(bone.scale), target("scale"));
  }
  for (const WeightAnimation& animated : animation.weights) {
    const MeshInstance& instance = scene.instances[animated.instance];
    if (animated.weights.target_count == instance.rest_weights.size())
      add(keys_of(animated.weights), {{"node", scene.skeleton.node_of_joint[instance.joint]}, {"path", "weights"}});
  }
  for (const PropertyTrack& track : animation.properties) {
    add(keys_of(track),
        {{"path", "pointer"},
         {"extensions", {{"KHR_animation_pointer", {{"pointer", property_pointer(track.target, scene)}}}}}});
    declare(draft, "KHR_animation_pointer", false);
  }
  if (out["channels"].empty()) add(Keys{Interpolation::step, {0.0f}, {0, 0, 0}, 3}, Json{{"path", "translation"}});
  writer.finish();
  return out;
}

}  // namespace

void add_animations(const Scene& scene, std::span<const Animation> animations, Draft& draft) {
  for (const Animation& animation : animations) {
    Json added = animation_of(scene, animation, draft);
    draft.json["animations"].push_back(std::move(added));
  }
}

}  // namespace sinew::rewrite
