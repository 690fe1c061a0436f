// SPDX-License-Identifier: MIT
#include "tests/viewer/built_scenes.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "samples/showcase/shapes.h"

namespace sinew::viewer {

std::uint32_t BuiltScene::add_material(const Material& material) {
  scene.materials.push_back(material);
  return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

std::uint32_t BuiltScene::add(const Primitive& primitive, std::uint32_t material, const Affine& world_from_mesh,
                              bool mirrored) {
  Mesh mesh;
  mesh.primitives.push_back(primitive);
  mesh.primitives[0].material = material;
  mesh.primitives[0].bounds = {};
  for (const glm::vec3& p : primitive.positions) mesh.primitives[0].bounds.add(p);
  scene.meshes.push_back(std::move(mesh));
  const auto index = static_cast<std::uint32_t>(scene.instances.size());
  scene.instances.push_back(
      {static_cast<std::uint32_t>(model_.size()), static_cast<std::uint32_t>(scene.meshes.size() - 1), kNone, {}});
  instances_.push_back(
      {.world_from_mesh = world_from_mesh, .first_primitive = index, .mirrored = mirrored, .bounds = {}});
  model_.push_back(world_from_mesh);
  moved_.emplace_back();
  return index;
}

void BuiltScene::add_light(const Light& light, const Affine& world_from_light) {
  scene.lights.push_back(light);
  scene.lights.back().joint = static_cast<std::uint32_t>(model_.size());
  model_.push_back(world_from_light);
}

void BuiltScene::deform(std::uint32_t instance, std::vector<glm::vec3> positions, std::vector<glm::vec3> normals) {
  moved_[instance] = {std::move(positions), std::move(normals)};
}

FrameResult BuiltScene::frame(std::uint64_t number) const {
  primitives_.clear();
  for (std::uint32_t i = 0; i < moved_.size(); ++i)
    primitives_.push_back({i, 0, moved_[i].positions, moved_[i].normals, {}, {}});
  FrameResult result;
  result.frame = number;
  result.model = model_;
  result.instances = instances_;
  result.primitives = primitives_;
  return result;
}

Material matte(const glm::vec3& color) {
  Material material;
  material.base_color = glm::vec4(color, 1.0f);
  material.metallic = 0.0f;
  material.roughness = 0.9f;
  return material;
}

Affine translation(const glm::vec3& t) {
  Affine m;
  for (int i = 0; i < 3; ++i) m.row[i].w = t[i];
  return m;
}

Primitive square(float half_size) {
  Primitive p;
  p.positions = {
      {-half_size, 0, -half_size}, {-half_size, 0, half_size}, {half_size, 0, half_size}, {half_size, 0, -half_size}};
  p.normals.assign(4, {0.0f, 1.0f, 0.0f});
  p.texcoords = {{{0, 0}, {0, 1}, {1, 1}, {1, 0}}};
  p.indices = {0, 1, 2, 0, 2, 3};
  return p;
}

BuiltScene box_and_sphere_on_floor() {
  BuiltScene built;
  const std::uint32_t grey = built.add_material(matte({0.7f, 0.7f, 0.7f}));
  const std::uint32_t red = built.add_material(matte({0.8f, 0.2f, 0.15f}));
  const std::uint32_t blue = built.add_material(matte({0.2f, 0.35f, 0.8f}));
  built.add(square(4.0f), grey);
  built.add(showcase::box({0.0f, 0.0f, 0.0f}, glm::vec3(0.6f)), red, translation({-0.9f, 0.6f, 0.0f}));
  built.add(showcase::sphere({0.0f, 0.0f, 0.0f}, 0.7f), blue, translation({0.8f, 0.7f, 0.3f}));
  return built;
}

BuiltScene bent_arm(float angle_rad) {
  BuiltScene built;
  const std::uint32_t skin = built.add_material(matte({0.85f, 0.6f, 0.45f}));
  const Primitive arm = showcase::grid(
      [](float u, float v) {
        const float turn = 6.2831853f * u, ring = 0.25f * std::min(1.0f, 8.0f * std::min(v, 1.0f - v));
        return glm::vec3(2.0f * v, ring * std::cos(turn), ring * std::sin(turn));
      },
      24, 24);
  const std::uint32_t instance = built.add(arm, skin);
  std::vector<glm::vec3> positions, normals;
  const float c = std::cos(angle_rad), s = std::sin(angle_rad);
  for (std::size_t i = 0; i < arm.positions.size(); ++i) {
    const glm::vec3 p = arm.positions[i], n = arm.normals[i];
    const float t = std::clamp((p.x - 0.7f) / 0.6f, 0.0f, 1.0f);
    const glm::vec3 local = p - glm::vec3(1.0f, 0.0f, 0.0f);
    const glm::vec3 turned(1.0f + c * local.x - s * local.y, s * local.x + c * local.y, local.z);
    positions.push_back((1.0f - t) * p + t * turned);
    normals.push_back(glm::normalize((1.0f - t) * n + t * glm::vec3(c * n.x - s * n.y, s * n.x + c * n.y, n.z)));
  }
  built.deform(instance, std::move(positions), std::move(normals));
  return built;
}

}  // namespace sinew::viewer
