// SPDX-License-Identifier: MIT
#include "tests/scenes/hand_scenes.h"

#include <cmath>

#include "runtime/base/contract.h"

namespace sinew::test {
namespace {

void add_joint(Scene& scene, const char* name, std::uint32_t parent, const glm::vec3& translation) {
  Skeleton& skeleton = scene.skeleton;
  const auto joint = static_cast<std::uint32_t>(skeleton.joint_count());
  skeleton.parents.push_back(parent);
  skeleton.rest.push_back({translation, glm::quat(1, 0, 0, 0), glm::vec3(1)});
  skeleton.fixed_matrix_of.push_back(kNone);
  skeleton.names.emplace_back(name);
  skeleton.node_of_joint.push_back(joint);
  skeleton.joint_of_node.push_back(joint);
}

Scene finished(Scene scene) {
  finish_scene(scene);
  CONTRACT(check(scene) == ErrorCode::ok);
  return scene;
}

Primitive flat_shape(std::vector<glm::vec3> positions, std::vector<std::uint32_t> indices) {
  Primitive primitive;
  primitive.normals.assign(positions.size(), glm::vec3(0, 0, 1));
  for (const glm::vec3& p : positions) primitive.bounds.add(p);
  primitive.positions = std::move(positions);
  primitive.indices = std::move(indices);
  return primitive;
}

Affine moved_by(const glm::vec3& t) { return affine_from(glm::mat3(1.0f), t); }

}  // namespace

Scene prop_scene() {
  Scene scene;
  add_joint(scene, "root", kNone, {0, 0, 0});
  scene.skeleton.level_begin = {0, 1};
  scene.meshes.push_back({"triangle", {flat_shape({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2})}, {}, {}});
  scene.instances.push_back({.joint = 0, .mesh = 0, .skin = kNone, .rest_weights = {}});
  return finished(std::move(scene));
}

Scene arm_scene() {
  Scene scene;
  add_joint(scene, "upper", kNone, {0, 0, 0});
  add_joint(scene, "holder", kNone, {5, 0, 0});
  add_joint(scene, "lower", 0, {0, 1, 0});
  scene.skeleton.level_begin = {0, 2, 3};
  scene.skins.push_back({"arm", {0, 2}, {Affine{}, moved_by({0, -1, 0})}, kNone});
  Primitive arm = flat_shape({{0, 0, 0}, {0, 2, 0}, {0.25f, 1, 0}, {-0.25f, 1, 0}}, {0, 2, 3, 2, 1, 3});
  arm.influences = {{{0, 2, 1, 0}, {2, 2, 2, 2}}, {0, 1, 0, 1, 0, 1}, {1, 1, 0.5f, 0.5f, 0.5f, 0.5f}};
  scene.meshes.push_back({"arm", {std::move(arm)}, {}, {}});
  scene.instances.push_back({.joint = 1, .mesh = 0, .skin = 0, .rest_weights = {}});
  BoneAnimation bend;
  bend.joint = 2;
  const float half = std::sqrt(0.5f);
  bend.rotation = {Interpolation::linear, {0, 1}, {glm::quat(1, 0, 0, 0), glm::quat(half, 0, 0, half)}};
  scene.animations.push_back({"bend", 1.0, {bend}, {}});
  return finished(std::move(scene));
}

Scene face_scene() {
  Scene scene;
  add_joint(scene, "root", kNone, {0, 0, 0});
  scene.skeleton.level_begin = {0, 1};
  Primitive face = flat_shape({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {0, 1, 2, 0, 2, 3});
  face.colors.assign(4, glm::vec4(0.25f, 0.5f, 0.75f, 1.0f));
  MorphTarget lift, spread;
  lift.positions = {{0}, {{0, 0, 1}}};
  lift.normals = {{0}, {{1, 0, 0}}};
  spread.positions = {{1, 2}, {{1, 0, 0}, {1, 0, 0}}};
  spread.colors = {{1, 2}, {{0.5f, 0, 0, 0}, {0.5f, 0, 0, 0}}};
  face.morphs.targets = {lift, spread};
  scene.meshes.push_back({"face", {std::move(face)}, {0.0f, 0.0f}, {"lift", "spread"}});
  scene.instances.push_back({.joint = 0, .mesh = 0, .skin = kNone, .rest_weights = {0.25f, 0.0f}});
  WeightTrack smile{Interpolation::linear, {0, 1}, {0, 0, 1, 2}, 2};
  scene.animations.push_back({"smile", 1.0, {}, {{0, smile}}});
  return finished(std::move(scene));
}

}  // namespace sinew::test
