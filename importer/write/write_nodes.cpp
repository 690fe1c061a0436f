// SPDX-License-Identifier: MIT
#include <string>

#include "importer/write/write_scene.h"

namespace sinew::write {
namespace {

void write_local(const Skeleton& skeleton, std::size_t joint, tinygltf::Node& node) {
  if (skeleton.fixed_matrix_of[joint] != kNone) {
    const glm::mat4 m = mat4_from_affine(skeleton.fixed_matrices[skeleton.fixed_matrix_of[joint]]);
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r) node.matrix.push_back(m[c][r]);
    return;
  }
  const Transform& rest = skeleton.rest[joint];
  const auto &t = rest.translation, &s = rest.scale;
  const auto& q = rest.rotation;
  if (t != glm::vec3(0.0f)) node.translation = {t.x, t.y, t.z};
  if (q != glm::quat(1.0f, 0.0f, 0.0f, 0.0f)) node.rotation = {q.x, q.y, q.z, q.w};
  if (s != glm::vec3(1.0f)) node.scale = {s.x, s.y, s.z};
}

void attach(const MeshInstance& instance, const Scene& scene, tinygltf::Node& node) {
  node.mesh = static_cast<int>(instance.mesh);
  if (instance.skin != kNone) node.skin = static_cast<int>(instance.skin);
  if (instance.rest_weights != scene.meshes[instance.mesh].default_weights)
    node.weights.assign(instance.rest_weights.begin(), instance.rest_weights.end());
}

/// Writes EXT_mesh_gpu_instancing.
void write_copies(const std::vector<Transform>& copies, tinygltf::Model& model, std::size_t node, GlbBuffer& buffer) {
  if (copies.empty()) return;
  declare_extension(model, "EXT_mesh_gpu_instancing");
  std::vector<glm::vec3> translations, scales;
  std::vector<glm::quat> rotations;
  for (const Transform& copy : copies) {
    translations.push_back(copy.translation);
    rotations.push_back(copy.rotation);
    scales.push_back(copy.scale);
  }
  const auto vectors = [&](const std::vector<glm::vec3>& v) {
    return tinygltf::Value(buffer.add(std::span<const glm::vec3>(v), false, ViewUse::other));
  };
  tinygltf::Value::Object attributes{{"TRANSLATION", vectors(translations)},
                                     {"ROTATION", tinygltf::Value(buffer.add_rotations(rotations))},
                                     {"SCALE", vectors(scales)}};
  model.nodes[node].extensions["EXT_mesh_gpu_instancing"] =
      tinygltf::Value(tinygltf::Value::Object{{"attributes", tinygltf::Value(std::move(attributes))}});
}

/// Writes KHR_node_visibility for hidden nodes and for nodes whose visibility is animated.
void write_visibility(const Scene& scene, tinygltf::Model& model) {
  const auto write = [&](std::uint32_t joint, bool visible) {
    declare_extension(model, "KHR_node_visibility");
    model.nodes[scene.skeleton.node_of_joint[joint]].extensions["KHR_node_visibility"] =
        tinygltf::Value(tinygltf::Value::Object{{"visible", tinygltf::Value(visible)}});
  };
  for (const PropertyTable::Entry& entry : scene.properties.entries)
    if (entry.target.kind == PropertyKind::node_visible) write(entry.target.index, true);
  for (const std::uint32_t joint : scene.hidden_joints) write(joint, false);
}

/// The node to attach an object to: the joint's own, or a new child node if `has_one(node)`, that is, it already has
/// such an object.
template <class HasOne>
std::size_t node_for(const Skeleton& skeleton, std::uint32_t joint, tinygltf::Model& model, HasOne has_one) {
  const std::size_t own = skeleton.node_of_joint[joint], below = model.nodes.size();
  if (!has_one(model.nodes[own])) return own;
  model.nodes[own].children.push_back(static_cast<int>(below));
  model.nodes.emplace_back();
  return below;
}

/// Newer releases of tinygltf have a member `light` and drop the extension if it is not set.
template <class Node>
void attach_light(Node& node, int light) {
  node.extensions["KHR_lights_punctual"] = tinygltf::Value(tinygltf::Value::Object{{"light", tinygltf::Value(light)}});
  if constexpr (requires { node.light; }) node.light = light;
}

std::vector<int> write_instances(const Scene& scene, tinygltf::Model& model, GlbBuffer& buffer) {
  std::vector<int> node_of_instance;
  for (const auto& instance : scene.instances) {
    const std::size_t node = node_for(scene.skeleton, instance.joint, model, [](const auto& n) { return n.mesh >= 0; });
    attach(instance, scene, model.nodes[node]);
    write_copies(instance.copies, model, node, buffer);
    node_of_instance.push_back(static_cast<int>(node));
  }
  return node_of_instance;
}

/// Attaches cameras and lights, which are already in the model, to the nodes of their joints.
void place_cameras_and_lights(const Scene& scene, tinygltf::Model& model) {
  const auto has_camera = [](const tinygltf::Node& node) { return node.camera >= 0; };
  const auto has_light = [](const tinygltf::Node& node) { return node.extensions.contains("KHR_lights_punctual"); };
  for (std::size_t i = 0; i < scene.cameras.size(); ++i)
    if (const std::uint32_t joint = scene.cameras[i].joint; joint != kNone)
      model.nodes[node_for(scene.skeleton, joint, model, has_camera)].camera = static_cast<int>(i);
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    if (const std::uint32_t joint = scene.lights[i].joint; joint != kNone)
      attach_light(model.nodes[node_for(scene.skeleton, joint, model, has_light)], static_cast<int>(i));
}

void write_skins(const Scene& scene, tinygltf::Model& model, GlbBuffer& buffer) {
  for (const auto& skin : scene.skins) {
    tinygltf::Skin out;
    out.name = skin.name;
    for (const std::uint32_t joint : skin.joints)
      out.joints.push_back(static_cast<int>(scene.skeleton.node_of_joint[joint]));
    if (skin.joints.empty()) out.joints.push_back(0);  // glTF requires at least one joint; no vertex uses it
    if (!skin.inverse_bind.empty()) out.inverseBindMatrices = buffer.add_matrices(skin.inverse_bind);
    if (skin.skeleton_root != kNone) out.skeleton = static_cast<int>(scene.skeleton.node_of_joint[skin.skeleton_root]);
    model.skins.push_back(std::move(out));
  }
}

}  // namespace

std::vector<int> write_nodes(const Scene& scene, tinygltf::Model& model, GlbBuffer& buffer) {
  const Skeleton& skeleton = scene.skeleton;
  model.nodes.resize(skeleton.joint_count());
  for (std::size_t j = 0; j < skeleton.joint_count(); ++j) {
    const auto index = skeleton.node_of_joint[j];
    auto& node = model.nodes[index];
    node.name = skeleton.names[j];
    write_local(skeleton, j, node);
    if (skeleton.parents[j] != kNone)
      model.nodes[skeleton.node_of_joint[skeleton.parents[j]]].children.push_back(static_cast<int>(index));
  }
  write_skins(scene, model, buffer);
  place_cameras_and_lights(scene, model);
  for (const auto& roots : scene.scenes) {
    tinygltf::Scene out;
    out.name = roots.name;
    for (const std::uint32_t joint : roots.joints) out.nodes.push_back(static_cast<int>(skeleton.node_of_joint[joint]));
    model.scenes.push_back(std::move(out));
  }
  if (scene.default_scene != kNone) model.defaultScene = static_cast<int>(scene.default_scene);
  write_visibility(scene, model);
  return write_instances(scene, model, buffer);
}

}  // namespace sinew::write
