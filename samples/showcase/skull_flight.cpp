// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "runtime/base/contract.h"
#include "samples/showcase/scene_builder.h"
#include "samples/showcase/shapes.h"
#include "samples/showcase/showcase.h"

namespace sinew::showcase {
namespace {

constexpr float kSkullRadius = 4.0f;
constexpr float kFloorY = -3.0f;

/// A bump on the unit sphere: 1 at `centre`, nearly 0 at a distance of three `width`s.
float bump(const glm::vec3& direction, const glm::vec3& centre, float width) {
  const glm::vec3 d = direction - glm::normalize(centre);
  return std::exp(-glm::dot(d, d) / (width * width));
}

/// Maps the unit sphere to a skull that looks along +Z, by moving points along their radius.
glm::vec3 skull_surface(const glm::vec3& direction) {
  const glm::vec3 mirrored(std::abs(direction.x), direction.y, direction.z);
  float radius = 1.0f;
  radius -= 0.34f * bump(mirrored, {0.40f, 0.02f, 0.90f}, 0.20f);   // eye sockets
  radius += 0.06f * bump(mirrored, {0.38f, 0.34f, 0.86f}, 0.17f);   // brows
  radius -= 0.17f * bump(mirrored, {0.06f, -0.30f, 0.95f}, 0.10f);  // nose
  radius += 0.10f * bump(mirrored, {0.66f, -0.24f, 0.72f}, 0.17f);  // cheekbones
  radius -= 0.22f * bump(mirrored, {0.74f, -0.62f, 0.42f}, 0.28f);  // hollow cheeks
  radius += 0.12f * bump(mirrored, {0.0f, -0.80f, 0.62f}, 0.34f);   // chin
  glm::vec3 p = radius * direction;
  const float lower = glm::smoothstep(0.05f, -0.9f, p.y);
  p.x *= 0.82f * (1.0f - 0.34f * lower);
  p.z *= p.z < 0.0f ? 1.08f - 0.55f * lower : 1.0f;
  return p;
}

/// Two rows of boxes that sit on the surface of the jaw.
Primitive teeth() {
  Primitive all;
  for (const float y : {-0.50f, -0.62f})
    for (int i = -3; i <= 3; ++i) {
      const float angle = 0.14f * static_cast<float>(i);
      const glm::vec3 on_jaw = skull_surface(glm::normalize(glm::vec3(std::sin(angle), y, std::cos(angle))));
      append(all, box(kSkullRadius * on_jaw, kSkullRadius * glm::vec3(0.040f, 0.050f, 0.035f)));
    }
  return all;
}

Mesh skull_mesh(std::uint32_t bone, std::uint32_t enamel, std::uint32_t dark) {
  Mesh mesh;
  mesh.name = "skull";
  const Primitive ball = sphere(glm::vec3(0.0f), 1.0f, 128, 96);
  Primitive cranium = ball;
  for (auto& p : cranium.positions) p = kSkullRadius * skull_surface(glm::normalize(p));
  cranium.normals = smooth_normals(cranium, cranium.positions);
  cranium.bounds = {};
  for (const auto& p : cranium.positions) cranium.bounds.add(p);
  cranium.material = bone;
  Primitive grin = teeth();
  grin.material = enamel;
  Primitive eyes = sphere(kSkullRadius * glm::vec3(0.28f, 0.02f, 0.58f), 0.11f * kSkullRadius);
  append(eyes, sphere(kSkullRadius * glm::vec3(-0.28f, 0.02f, 0.58f), 0.11f * kSkullRadius));
  eyes.material = dark;
  mesh.primitives = {std::move(cranium), std::move(grin), std::move(eyes)};
  return mesh;
}

Keyframe key(double time_s, const glm::vec3& translation, float scale, const glm::vec3& axis, float degrees) {
  return {time_s, translation, glm::angleAxis(glm::radians(degrees), glm::normalize(axis)), glm::vec3(scale)};
}

BoneAnimation flight(std::uint32_t joint) {
  const Keyframe keys[] = {
      key(0.0, {-7.0f, 0.0f, 0.0f}, 0.25f, {0.0f, 1.0f, 0.0f}, 30.0f),
      key(2.0, {0.0f, 2.0f, 10.0f}, 0.50f, {1.0f, 1.0f, 2.0f}, 45.0f),
      key(4.0, {7.0f, 0.0f, 0.0f}, 0.25f, {0.0f, 1.0f, 0.0f}, -30.0f),
      key(6.0, {0.0f, 1.0f, -10.0f}, 0.50f, {1.0f, 0.0f, 0.0f}, 70.0f),
      key(8.0, {-7.0f, 0.0f, 0.0f}, 0.25f, {0.0f, 1.0f, 0.0f}, 30.0f),
  };
  auto animation = BoneAnimation::from_keyframes(joint, keys);
  CONTRACT(animation.has_value());
  return *std::move(animation);
}

Primitive columns() {
  Primitive all;
  const auto profile = [](float v) {
    const float foot = std::max(0.0f, 1.0f - 14.0f * v), head = std::max(0.0f, 1.0f - 14.0f * (1.0f - v));
    return 0.6f + 0.35f * (foot + head);
  };
  for (const float x : {-11.0f, 11.0f})
    for (int i = -2; i <= 2; ++i)
      append(all, lathe({x, kFloorY - 0.05f, 6.0f * static_cast<float>(i)}, 4.05f, profile, 24, 30));
  return all;
}

Primitive spheres_on_columns() {
  Primitive all;
  for (const float x : {-11.0f, 11.0f})
    for (int i = -2; i <= 2; ++i) append(all, sphere({x, kFloorY + 5.0f, 6.0f * static_cast<float>(i)}, 1.0f, 32, 20));
  return all;
}

}  // namespace

ShowcaseScene skull_flight() {
  SceneBuilder builder;
  const std::uint32_t stone = builder.add_material("stone", {0.62f, 0.60f, 0.56f}, 0.9f);
  const std::uint32_t marble = builder.add_material("marble", {0.78f, 0.76f, 0.72f}, 0.6f);
  const std::uint32_t copper = builder.add_material("copper", {0.72f, 0.36f, 0.22f}, 0.35f);
  const std::uint32_t wood = builder.add_material("wood", {0.45f, 0.30f, 0.18f}, 0.8f);
  const std::uint32_t bone = builder.add_material("bone", {0.86f, 0.80f, 0.66f}, 0.7f);
  const std::uint32_t enamel = builder.add_material("enamel", {0.93f, 0.91f, 0.84f}, 0.3f);
  const std::uint32_t dark = builder.add_material("eyes", {0.10f, 0.02f, 0.02f}, 0.2f);

  builder.add_prop(
      "floor", grid([](float u, float v) { return glm::vec3(40.0f * (u - 0.5f), kFloorY, 40.0f * (0.5f - v)); }, 8, 8),
      stone);
  builder.add_prop("box", box({0.0f, kFloorY + 1.25f, 0.0f}, glm::vec3(1.6f, 1.25f, 1.6f)), wood);
  builder.add_prop("columns", columns(), marble);
  builder.add_prop("spheres", spheres_on_columns(), copper);
  const std::uint32_t skull = builder.add_joint("skull", kNone, Transform{});
  builder.add_instance(skull, builder.add_mesh(skull_mesh(bone, enamel, dark)));

  Animation animation;
  animation.name = "flight";
  animation.duration_s = 8.0;
  animation.bones.push_back(flight(skull));
  builder.add_animation(std::move(animation));

  ShowcaseScene out;
  out.name = "skull flight";
  out.what_to_look_at =
      "Five keyframes carry the skull; ambient occlusion grounds the columns, the box and the eye sockets.";
  out.scene = builder.finish();
  out.eye = {15.0f, 8.0f, 24.0f};
  out.target = {0.0f, -1.0f, 0.0f};
  out.fov_y_rad = 0.66f;
  return out;
}

}  // namespace sinew::showcase
