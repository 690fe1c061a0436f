// SPDX-License-Identifier: MIT
#include "samples/showcase/scene_builder.h"

#include <utility>

#include "runtime/base/contract.h"

namespace sinew::showcase {

std::uint32_t SceneBuilder::add_material(std::string name, const glm::vec3& base_color, float roughness,
                                         float metallic) {
  Material material;
  material.name = std::move(name);
  material.base_color = {base_color, 1.0f};
  material.roughness = roughness;
  material.metallic = metallic;
  return add_material(std::move(material));
}

std::uint32_t SceneBuilder::add_material(Material material) {
  scene_.materials.push_back(std::move(material));
  return static_cast<std::uint32_t>(scene_.materials.size() - 1);
}

std::uint32_t SceneBuilder::add_texture(Image image, const Sampler& sampler) {
  scene_.images.push_back(std::move(image));
  scene_.textures.push_back({static_cast<std::uint32_t>(scene_.images.size() - 1), sampler});
  return static_cast<std::uint32_t>(scene_.textures.size() - 1);
}

std::uint32_t SceneBuilder::add_joint(std::string name, std::uint32_t parent, const Transform& rest) {
  Skeleton& skeleton = scene_.skeleton;
  const auto joint = static_cast<std::uint32_t>(skeleton.joint_count());
  const std::uint32_t depth = parent == kNone ? 0 : depth_[parent] + 1;
  CONTRACT(depth_.empty() || depth >= depth_.back());
  if (depth_.empty() || depth > depth_.back()) skeleton.level_begin.push_back(joint);
  depth_.push_back(depth);
  skeleton.parents.push_back(parent);
  skeleton.rest.push_back(rest);
  skeleton.fixed_matrix_of.push_back(kNone);
  skeleton.names.push_back(std::move(name));
  skeleton.node_of_joint.push_back(joint);
  skeleton.joint_of_node.push_back(joint);
  return joint;
}

std::uint32_t SceneBuilder::add_skin(Skin skin) {
  scene_.skins.push_back(std::move(skin));
  return static_cast<std::uint32_t>(scene_.skins.size() - 1);
}

std::uint32_t SceneBuilder::add_mesh(Mesh mesh) {
  scene_.meshes.push_back(std::move(mesh));
  return static_cast<std::uint32_t>(scene_.meshes.size() - 1);
}

void SceneBuilder::add_instance(std::uint32_t joint, std::uint32_t mesh, std::uint32_t skin) {
  scene_.instances.push_back({joint, mesh, skin, scene_.meshes[mesh].default_weights});
}

void SceneBuilder::add_light(Light light, const Transform& rest) {
  light.joint = add_joint(light.name, kNone, rest);
  scene_.lights.push_back(std::move(light));
}

void SceneBuilder::add_animation(Animation animation) { scene_.animations.push_back(std::move(animation)); }

std::uint32_t SceneBuilder::add_prop(const std::string& name, Primitive primitive, std::uint32_t material,
                                     const Transform& rest) {
  primitive.material = material;
  Mesh mesh;
  mesh.name = name;
  mesh.primitives.push_back(std::move(primitive));
  const std::uint32_t joint = add_joint(name, kNone, rest);
  add_instance(joint, add_mesh(std::move(mesh)));
  return joint;
}

Scene SceneBuilder::finish() {
  Skeleton& skeleton = scene_.skeleton;
  skeleton.level_begin.push_back(static_cast<std::uint32_t>(skeleton.joint_count()));
  SceneRoots roots;
  for (std::uint32_t j = 0; j < skeleton.joint_count(); ++j)
    if (skeleton.parents[j] == kNone) roots.joints.push_back(j);
  scene_.scenes.push_back(std::move(roots));
  scene_.default_scene = 0;
  finish_scene(scene_);
  CONTRACT(check(scene_) == ErrorCode::ok);
  return std::move(scene_);
}

}  // namespace sinew::showcase
