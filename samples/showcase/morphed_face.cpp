// SPDX-License-Identifier: MIT
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "samples/showcase/scene_builder.h"
#include "samples/showcase/shapes.h"
#include "samples/showcase/showcase.h"

namespace sinew::showcase {
namespace {

/// Gaussian around `centre`: 1 there, 1/e at a distance of `width` along an axis.
float near_point(const glm::vec3& p, const glm::vec3& centre, const glm::vec3& width) {
  const glm::vec3 d = (p - centre) / width;
  return std::exp(-glm::dot(d, d));
}

/// Maps the unit sphere to a face that looks along +Z.
glm::vec3 neutral_face(const glm::vec3& direction) {
  glm::vec3 p = direction * glm::vec3(0.84f, 1.08f, 0.92f);
  const glm::vec3 half(std::abs(p.x), p.y, p.z);
  p.x *= 1.0f - 0.22f * glm::smoothstep(-0.1f, -1.0f, p.y);                                          // chin
  p.z += 0.24f * near_point(half, {0.0f, -0.08f, 0.95f}, {0.13f, 0.20f, 0.5f});                      // nose
  p.z -= 0.20f * near_point(half, {0.31f, 0.18f, 0.85f}, {0.17f, 0.11f, 0.5f});                      // eye sockets
  p.z += 0.05f * near_point(half, {0.30f, 0.36f, 0.80f}, {0.24f, 0.08f, 0.5f});                      // brows
  p.z += 0.07f * near_point(half, {0.0f, -0.44f, 0.90f}, {0.24f, 0.05f, 0.5f});                      // upper lip
  p.z += 0.06f * near_point(half, {0.0f, -0.60f, 0.85f}, {0.20f, 0.05f, 0.5f});                      // lower lip
  p.z -= 0.10f * near_point(half, {0.0f, -0.52f, 0.90f}, {0.27f, 0.022f, 0.5f});                     // mouth line
  p.x += (p.x > 0 ? 0.14f : -0.14f) * near_point(half, {0.84f, 0.05f, 0.0f}, {0.3f, 0.18f, 0.11f});  // ears
  return p;
}

struct Expression {
  const char* name;
  std::function<glm::vec3(const glm::vec3& neutral)> displacement;
};

std::vector<Expression> expressions() {
  const auto half = [](const glm::vec3& p) { return glm::vec3(std::abs(p.x), p.y, p.z); };
  const auto side = [](const glm::vec3& p) { return p.x < 0.0f ? -1.0f : 1.0f; };
  return {
      {"smile",
       [=](const glm::vec3& p) {
         const float corner = near_point(half(p), {0.26f, -0.52f, 0.80f}, {0.16f, 0.16f, 0.4f});
         const float cheek = near_point(half(p), {0.42f, -0.22f, 0.75f}, {0.18f, 0.16f, 0.4f});
         return corner * glm::vec3(0.07f * side(p), 0.13f, -0.02f) + cheek * glm::vec3(0.02f * side(p), 0.05f, 0.06f);
       }},
      {"open",
       [=](const glm::vec3& p) {
         const float jaw = glm::smoothstep(-0.50f, -0.60f, p.y) * glm::smoothstep(-0.3f, 0.3f, p.z);
         return jaw * glm::vec3(0.0f, -0.20f, -0.05f);
       }},
      {"brows",
       [=](const glm::vec3& p) {
         return near_point(half(p), {0.28f, 0.38f, 0.85f}, {0.24f, 0.14f, 0.4f}) * glm::vec3(0.0f, 0.14f, 0.02f);
       }},
      {"puff",
       [=](const glm::vec3& p) {
         return near_point(half(p), {0.48f, -0.36f, 0.62f}, {0.22f, 0.22f, 0.4f}) *
                glm::vec3(0.15f * side(p), 0.0f, 0.10f);
       }},
  };
}

constexpr float kNoticeable = 1e-4f;  // smaller displacements (0.1 mm) are dropped, so that the targets stay sparse

MorphTarget target(const Primitive& head, const Expression& expression) {
  std::vector<glm::vec3> moved = head.positions;
  for (auto& p : moved) {
    const glm::vec3 d = expression.displacement(p);
    if (glm::length(d) > kNoticeable) p += d;
  }
  const std::vector<glm::vec3> normals = smooth_normals(head, moved);
  MorphTarget out;
  for (std::uint32_t v = 0; v < moved.size(); ++v) {
    if (moved[v] != head.positions[v]) {
      out.positions.vertices.push_back(v);
      out.positions.deltas.push_back(moved[v] - head.positions[v]);
    }
    const glm::vec3 turn = normals[v] - head.normals[v];
    if (glm::length(turn) > kNoticeable) {
      out.normals.vertices.push_back(v);
      out.normals.deltas.push_back(turn);
    }
  }
  return out;
}

Mesh face_mesh(std::uint32_t material) {
  Primitive head = sphere(glm::vec3(0.0f), 1.0f, 160, 120);
  for (auto& p : head.positions) p = neutral_face(glm::normalize(p));
  head.normals = smooth_normals(head, head.positions);
  head.bounds = {};
  for (const auto& p : head.positions) head.bounds.add(p);
  head.material = material;
  Mesh mesh;
  mesh.name = "face";
  for (const auto& expression : expressions()) {
    head.morphs.targets.push_back(target(head, expression));
    mesh.target_names.emplace_back(expression.name);
    mesh.default_weights.push_back(0.0f);
  }
  mesh.primitives.push_back(std::move(head));
  return mesh;
}

/// Weights over time: a smile of -1 is a frown, one of 1.5 a grin. Every expression leaves [0, 1] once.
WeightAnimation play_of_features(std::uint32_t instance) {
  WeightAnimation out;
  out.instance = instance;
  out.weights.target_count = 4;
  out.weights.times_s = {0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f, 8.0f};
  out.weights.values = {
      0.0f,  0.0f,  0.0f,  0.0f,   // neutral
      1.5f,  0.0f,  0.6f,  0.0f,   // grin, beyond 1
      1.0f,  1.0f,  1.3f,  0.0f,   // laugh
      0.0f,  0.0f,  0.0f,  0.0f,   //
      -1.0f, 0.0f,  -0.8f, 0.0f,   // frown, below 0
      0.0f,  -0.1f, 0.8f,  1.4f,   // puffed cheeks
      -0.4f, 0.0f,  1.0f,  -0.7f,  // sucked in
      0.2f,  1.3f,  1.4f,  -0.3f,  // surprise
      0.0f,  0.0f,  0.0f,  0.0f,
  };
  return out;
}

}  // namespace

ShowcaseScene morphed_face() {
  SceneBuilder builder;
  const std::uint32_t clay = builder.add_material("clay", {0.76f, 0.50f, 0.38f}, 0.65f);
  const std::uint32_t white = builder.add_material("eye white", {0.92f, 0.92f, 0.90f}, 0.2f);
  const std::uint32_t pupil = builder.add_material("pupil", {0.03f, 0.04f, 0.06f}, 0.1f);
  const std::uint32_t wall = builder.add_material("wall", {0.50f, 0.55f, 0.60f}, 0.95f);

  const std::uint32_t face = builder.add_joint("face", kNone, {});
  builder.add_instance(face, builder.add_mesh(face_mesh(clay)));
  for (const float x : {-0.30f, 0.30f}) {
    Transform rest;
    rest.translation = {x, 0.18f, 0.62f};
    builder.add_prop(x < 0.0f ? "right eye" : "left eye", sphere(glm::vec3(0.0f), 0.155f), white, rest);
    rest.translation += glm::vec3(0.0f, 0.0f, 0.125f);
    builder.add_prop(x < 0.0f ? "right pupil" : "left pupil", sphere(glm::vec3(0.0f), 0.065f), pupil, rest);
  }
  builder.add_prop("wall",
                   grid([](float u, float v) { return glm::vec3(9.0f * (u - 0.5f), 6.0f * (v - 0.5f), -1.1f); }, 2, 2),
                   wall);

  Animation animation;
  animation.name = "expressions";
  animation.duration_s = 8.0;
  animation.weights.push_back(play_of_features(0));
  builder.add_animation(std::move(animation));

  ShowcaseScene out;
  out.name = "morphed face";
  out.what_to_look_at = "Four sparse morph targets, with weights from -1 to 1.5.";
  out.scene = builder.finish();
  out.eye = {1.1f, 0.5f, 4.6f};
  out.target = {0.0f, -0.05f, 0.0f};
  out.fov_y_rad = 0.55f;
  return out;
}

std::vector<ShowcaseScene> showcase(std::span<const std::byte> flag_cache) {
  std::vector<ShowcaseScene> all;
  all.push_back(skull_flight());
  all.push_back(twisted_arms());
  all.push_back(morphed_face());
  if (!flag_cache.empty()) all.push_back(flag_in_wind(flag_cache));
  return all;
}

}  // namespace sinew::showcase
