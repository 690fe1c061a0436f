// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "runtime/base/contract.h"
#include "samples/showcase/scene_builder.h"
#include "samples/showcase/shapes.h"
#include "samples/showcase/showcase.h"

namespace sinew::showcase {
namespace {

constexpr float kLength = 4.0f;  // shoulder to finger tips
constexpr float kElbow = 1.4f, kWrist = 3.0f;
constexpr int kArms = 3;
constexpr float kSpacing = 2.2f;  // between neighbouring arms
constexpr float kFloorY = 0.08f;  // the floor hides the lower rim of the arms

/// Radius of the arm along its length, v in [0, 1]: upper arm, elbow, forearm, wrist, fist.
float arm_radius(float v) {
  const float muscle =
      0.10f * std::exp(-std::pow((v - 0.18f) / 0.12f, 2.0f)) + 0.08f * std::exp(-std::pow((v - 0.47f) / 0.11f, 2.0f));
  const float fist = 0.17f * std::exp(-std::pow((v - 0.88f) / 0.075f, 2.0f));
  const float shoulder = 0.10f * std::exp(-std::pow(v / 0.07f, 2.0f));
  const float tip = std::sqrt(std::max(0.0f, 1.0f - std::pow(std::max(0.0f, v - 0.86f) / 0.14f, 4.0f)));
  return (0.36f - 0.12f * v + muscle + fist + shoulder) * tip;
}

/// Colour of painted bands along the arm, which make the twist visible.
glm::vec4 band_color(const glm::vec3& p) {
  const float angle = std::atan2(p.x, p.z);
  const bool band = std::sin(4.0f * angle) > 0.35f;
  return band ? glm::vec4(0.16f, 0.30f, 0.55f, 1.0f) : glm::vec4(0.85f, 0.62f, 0.50f, 1.0f);
}

/// Weight of the wrist joint: 0 above the elbow, 1 beyond the wrist, linear between.
float wrist_weight(float y) { return glm::clamp((y - kElbow) / (kWrist - kElbow), 0.0f, 1.0f); }

/// Sorts the vertices by influence count, as the importer does, and adapts the indices.
void bind(Primitive& primitive) {
  std::vector<std::uint32_t> order;
  std::size_t single = 0;
  for (const bool wants_single : {true, false}) {
    for (std::uint32_t v = 0; v < primitive.vertex_count(); ++v) {
      const float w = wrist_weight(primitive.positions[v].y);
      if ((w <= 0.0f || w >= 1.0f) == wants_single) order.push_back(v);
    }
    if (wants_single) single = order.size();
  }
  std::vector<std::uint32_t> new_index(order.size());
  Primitive sorted = primitive;
  auto& influences = sorted.influences;
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    const std::uint32_t v = order[i];
    new_index[v] = i;
    sorted.positions[i] = primitive.positions[v];
    sorted.normals[i] = primitive.normals[v];
    sorted.colors[i] = primitive.colors[v];
    const float w = wrist_weight(primitive.positions[v].y);
    const bool wrist_first = w > 0.5f;
    influences.joints.push_back(wrist_first ? 1 : 0);
    influences.weights.push_back(wrist_first ? w : 1.0f - w);
    if (i < single) continue;
    influences.joints.push_back(wrist_first ? 0 : 1);
    influences.weights.push_back(wrist_first ? 1.0f - w : w);
  }
  for (auto& index : sorted.indices) index = new_index[index];
  const auto singles = static_cast<std::uint32_t>(single);
  influences.groups = {{0, singles, 1, 0}, {singles, static_cast<std::uint32_t>(order.size()) - singles, 2, singles}};
  sorted.source_vertex = order;
  primitive = std::move(sorted);
}

Mesh arm_mesh(std::uint32_t material) {
  Primitive arm = lathe(glm::vec3(0.0f), kLength, arm_radius, 96, 128);
  for (const auto& p : arm.positions) arm.colors.push_back(band_color(p));
  bind(arm);
  arm.material = material;
  Mesh mesh;
  mesh.name = "arm";
  mesh.primitives.push_back(std::move(arm));
  return mesh;
}

BoneAnimation twist(std::uint32_t joint) {
  // Quarter turns, because keys 180 degrees apart have two arcs of the same length.
  std::vector<Keyframe> keys;
  const float degrees[] = {0.0f, 90.0f, 180.0f, 180.0f, 90.0f, 0.0f};
  const double times_s[] = {0.0, 1.5, 3.0, 4.0, 5.5, 7.0};
  for (int i = 0; i < 6; ++i)
    keys.push_back({times_s[i],
                    {0.0f, kWrist, 0.0f},
                    glm::angleAxis(glm::radians(degrees[i]), glm::vec3(0.0f, 1.0f, 0.0f)),
                    glm::vec3(1.0f)});
  auto animation = BoneAnimation::from_keyframes(joint, keys);
  CONTRACT(animation.has_value());
  return *std::move(animation);
}

Affine moved(float x, float y) {
  Affine m;
  m.row[0].w = x;
  m.row[1].w = y;
  return m;
}

}  // namespace

ShowcaseScene twisted_arms() {
  SceneBuilder builder;
  const std::uint32_t skin_paint = builder.add_material("skin", glm::vec3(1.0f), 0.55f);
  const std::uint32_t stone = builder.add_material("stone", {0.55f, 0.56f, 0.60f}, 0.9f);
  builder.add_prop(
      "floor", grid([](float u, float v) { return glm::vec3(14.0f * (u - 0.5f), kFloorY, 14.0f * (0.5f - v)); }, 4, 4),
      stone);

  const char* const names[kArms] = {"linear blend", "dual quaternion", "center of rotation"};
  std::uint32_t shoulders[kArms], wrists[kArms], holders[kArms];
  for (int arm = 0; arm < kArms; ++arm) {
    Transform rest;
    rest.translation.x = kSpacing * static_cast<float>(arm - 1);
    shoulders[arm] = builder.add_joint(std::string(names[arm]) + " shoulder", kNone, rest);
  }
  for (int arm = 0; arm < kArms; ++arm) holders[arm] = builder.add_joint(names[arm], kNone, {});
  const std::uint32_t mesh = builder.add_mesh(arm_mesh(skin_paint));
  Animation animation;
  animation.name = "twist";
  animation.duration_s = 7.0;
  for (int arm = 0; arm < kArms; ++arm) {
    Transform rest;
    rest.translation.y = kWrist;
    wrists[arm] = builder.add_joint(std::string(names[arm]) + " wrist", shoulders[arm], rest);
    animation.bones.push_back(twist(wrists[arm]));
    Skin skin;
    skin.name = names[arm];
    skin.joints = {shoulders[arm], wrists[arm]};
    skin.inverse_bind = {Affine{}, moved(0.0f, -kWrist)};
    builder.add_instance(holders[arm], mesh, builder.add_skin(std::move(skin)));
  }
  builder.add_animation(std::move(animation));

  ShowcaseScene out;
  out.name = "twisted arms";
  out.what_to_look_at =
      "Left: linear-blend skinning loses the forearm's volume as the wrist turns. "
      "Dual quaternions in the middle and centers of rotation on the right keep it.";
  out.scene = builder.finish();
  out.needs.skin.per_instance = {Skinning::linear, Skinning::linear, Skinning::dual_quaternion,
                                 Skinning::center_of_rotation};
  out.eye = {1.5f, 3.2f, 10.5f};
  out.target = {0.0f, 2.0f, 0.0f};
  out.fov_y_rad = 0.60f;
  return out;
}

}  // namespace sinew::showcase
