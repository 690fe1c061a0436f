// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "runtime/base/contract.h"
#include "runtime/math/rotation_between.h"
#include "samples/showcase/polygonise.h"
#include "samples/showcase/scene_builder.h"
#include "samples/showcase/shapes.h"
#include "samples/showcase/showcase.h"
#include "samples/showcase/skull_bones.h"
#include "samples/showcase/skull_teeth.h"

namespace sinew::showcase {
namespace {

using Bone = float (*)(const glm::vec3&);

constexpr float kPlainY = -3.0f;

/// Scales bones from centimetres to a mesh around the middle of the head, 8 units high.
Primitive to_scene(Primitive part, std::uint32_t material) {
  part.bounds = {};
  for (glm::vec3& p : part.positions) {
    p = 0.36f * (p - glm::vec3(0.0f, 0.5f, 0.5f));
    part.bounds.add(p);
  }
  part.material = material;
  return part;
}

/// Colour of the bone: darker in hollows, and slightly stained everywhere.
glm::vec4 patina(Bone bone, const glm::vec3& p, const glm::vec3& normal) {
  float open = 1.0f;
  for (const float ahead : {0.7f, 2.4f}) open *= glm::smoothstep(-0.15f, 1.0f, bone(p + ahead * normal) / ahead);
  const float stain =
      std::sin(0.9f * p.x + 1.7f * std::sin(0.6f * p.y)) * std::sin(0.8f * p.y - 1.3f * std::sin(0.7f * p.z));
  const glm::vec3 clean = glm::min(glm::vec3(1.0f, 0.97f, 0.92f) - 0.07f * stain, 1.0f), hollow(0.30f, 0.20f, 0.13f);
  return {glm::mix(hollow, clean, 0.15f + 0.85f * open), 1.0f};
}

Primitive surface(Bone bone, const Aabb& bounds) {
  Primitive out = polygonise(bone, bounds, 0.34f);
  for (std::size_t v = 0; v < out.positions.size(); ++v)
    out.colors.push_back(patina(bone, out.positions[v], out.normals[v]));
  return out;
}

Mesh skull_mesh(std::uint32_t bone, std::uint32_t enamel) {
  Primitive bones = surface(cranium, kCranium);
  append(bones, surface(mandible, kMandible));
  Mesh mesh;
  mesh.name = "skull";
  mesh.primitives = {to_scene(std::move(bones), bone), to_scene(skull_teeth(), enamel)};
  return mesh;
}

Keyframe key(double time_s, const glm::vec3& translation, float scale, const glm::vec3& axis, float degrees) {
  return {time_s, translation, glm::angleAxis(glm::radians(degrees), glm::normalize(axis)), glm::vec3(scale)};
}

BoneAnimation flight(std::uint32_t joint) {
  const Keyframe keys[] = {
      key(0.0, {-7.0f, 0.0f, 0.0f}, 0.25f, {0.0f, 1.0f, 0.0f}, 30.0f),
      key(2.0, {-0.6f, 1.4f, 10.0f}, 0.8f, {0.5f, -0.4f, 0.8f}, 11.0f),
      key(4.0, {7.0f, 0.0f, 0.0f}, 0.25f, {0.0f, 1.0f, 0.0f}, -30.0f),
      key(6.0, {0.0f, 1.0f, -10.0f}, 0.50f, {1.0f, 0.0f, 0.0f}, 70.0f),
      key(8.0, {-7.0f, 0.0f, 0.0f}, 0.25f, {0.0f, 1.0f, 0.0f}, 30.0f),
  };
  auto animation = BoneAnimation::from_keyframes(joint, keys);
  CONTRACT(animation.has_value());
  return *std::move(animation);
}

/// A floor that curves up into a wall behind the scene.
Primitive cove() {
  constexpr float kBend = 9.0f, kWall = 14.0f, kFloor = 44.0f, kQuarter = 0.5f * std::numbers::pi_v<float> * kBend;
  return grid(
      [=](float u, float v) {
        const float along = v * (kFloor + kQuarter + kWall), up = std::max(along - kFloor - kQuarter, 0.0f);
        const float angle = glm::clamp((along - kFloor) / kBend, 0.0f, kQuarter / kBend);
        return glm::vec3(90.0f * (u - 0.5f), kPlainY + kBend * (1.0f - std::cos(angle)) + up,
                         28.0f - std::min(along, kFloor) - kBend * std::sin(angle));
      },
      1, 64);
}

Primitive columns() {
  Primitive all;
  const auto profile = [](float v) {
    const float foot = std::max(0.0f, 1.0f - 14.0f * v), head = std::max(0.0f, 1.0f - 14.0f * (1.0f - v));
    return 0.6f + 0.35f * (foot + head);
  };
  for (const float x : {-11.0f, 11.0f})
    for (int i = -2; i <= 2; ++i)
      append(all, lathe({x, kPlainY - 0.05f, 6.0f * static_cast<float>(i)}, 4.05f, profile, 24, 30));
  return all;
}

Primitive spheres_on_columns() {
  Primitive all;
  for (const float x : {-11.0f, 11.0f})
    for (int i = -2; i <= 2; ++i) append(all, sphere({x, kPlainY + 5.0f, 6.0f * static_cast<float>(i)}, 1.0f, 32, 20));
  return all;
}

}  // namespace

ShowcaseScene skull_flight() {
  SceneBuilder builder;
  const std::uint32_t stone = builder.add_material("stone", {0.10f, 0.13f, 0.16f}, 0.5f);
  const std::uint32_t marble = builder.add_material("marble", {0.66f, 0.64f, 0.60f}, 0.6f);
  const std::uint32_t copper = builder.add_material("copper", {0.95f, 0.60f, 0.42f}, 0.3f, 1.0f);
  const std::uint32_t gold = builder.add_material("gold", {1.0f, 0.77f, 0.34f}, 0.18f, 1.0f);
  Material red = {.name = "lacquer", .base_color = {0.45f, 0.03f, 0.03f, 1.0f}, .metallic = 0.0f, .roughness = 0.6f};
  red.clearcoat = {.factor = 1.0f, .roughness = 0.05f};
  const std::uint32_t lacquer = builder.add_material(std::move(red));
  const std::uint32_t bone = builder.add_material("bone", {0.86f, 0.80f, 0.66f}, 0.7f);
  const std::uint32_t enamel = builder.add_material("enamel", {0.90f, 0.86f, 0.75f}, 0.3f);

  builder.add_prop("cove", cove(), stone);
  builder.add_prop("large ball", sphere({4.2f, kPlainY + 1.5f, 1.0f}, 1.5f, 64, 32), lacquer);
  builder.add_prop("small ball", sphere({6.4f, kPlainY + 0.8f, 3.2f}, 0.8f, 48, 24), gold);
  builder.add_prop("columns", columns(), marble);
  builder.add_prop("spheres", spheres_on_columns(), copper);
  const std::uint32_t skull = builder.add_joint("skull", kNone, Transform{});
  builder.add_light({.name = "sun", .kind = Light::Kind::directional, .color = {1.0f, 0.93f, 0.82f}, .intensity = 2.6f},
                    {.rotation = rotation_between(glm::vec3(0.0f, 0.0f, 1.0f), glm::vec3(-0.65f, 0.9f, 0.4f))});
  builder.add_light({.name = "rim", .kind = Light::Kind::point, .color = {0.55f, 0.75f, 1.0f}, .intensity = 110.0f},
                    {.translation = {7.0f, 6.0f, 3.0f}});
  builder.add_instance(skull, builder.add_mesh(skull_mesh(bone, enamel)));

  Animation animation;
  animation.name = "flight";
  animation.duration_s = 8.0;
  animation.bones.push_back(flight(skull));
  builder.add_animation(std::move(animation));

  ShowcaseScene out;
  out.name = "skull flight";
  out.what_to_look_at =
      "Five keyframes carry the skull; ambient occlusion grounds the columns and the balls, and darkens the eye "
      "sockets.";
  out.scene = builder.finish();
  out.eye = {5.0f, 2.2f, 24.0f};
  out.target = {0.8f, 0.8f, 0.0f};
  out.fov_y_rad = 0.6f;
  return out;
}

}  // namespace sinew::showcase
