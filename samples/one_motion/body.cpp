// SPDX-License-Identifier: MIT
#include "samples/one_motion/body.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "runtime/math/rotation_between.h"
#include "samples/showcase/shapes.h"

using namespace sinew;

namespace {

enum Joint : std::uint16_t {
  hips,
  spine,
  left_thigh,
  right_thigh,
  neck,
  left_arm,
  right_arm,
  left_shank,
  right_shank,
  head,
  left_forearm,
  right_forearm,
  left_foot,
  right_foot,
  left_hand,
  right_hand,
  left_toes,
  right_toes
};

constexpr float kAnkle_m = 0.08f;
constexpr double kRun_s = 0.8;

Quat<float> about(const glm::vec3& axis, float angle_rad) { return glm::angleAxis(angle_rad, axis); }
Quat<float> about_x(float angle_rad) { return about({1, 0, 0}, angle_rad); }

/// Joint positions relative to their parents in the T-pose; +x is the body's left, +z its front.
std::array<glm::vec3, kJoints> t_pose(const Build& b) {
  const glm::vec3 arm(b.shoulders, 0.88f * b.spine, 0), thigh(0.42f * b.shoulders + 0.02f, 0, 0),
      sole(0, -0.8f * kAnkle_m, b.foot);
  const glm::vec3 flip(-1, 1, 1);
  return {glm::vec3(0, kAnkle_m + b.shank + b.thigh, 0),
          {0, 0.1f, 0},
          thigh,
          flip * thigh,
          {0, b.spine, 0},
          arm,
          flip * arm,
          {0, -b.thigh, 0},
          {0, -b.thigh, 0},
          {0, b.neck, 0},
          {b.upper_arm, 0, 0},
          {-b.upper_arm, 0, 0},
          {0, -b.shank, 0},
          {0, -b.shank, 0},
          {b.forearm, 0, 0},
          {-b.forearm, 0, 0},
          sole,
          sole};
}

std::array<glm::vec3, kJoints> places_in_t_pose(const Build& build) {
  std::array<glm::vec3, kJoints> places = t_pose(build);
  for (std::uint32_t j = 1; j < kJoints; ++j) places[j] += places[body_joints()[j].parent];
  return places;
}

/// A capsule with two different end radii.
Primitive capsule(const glm::vec3& a, const glm::vec3& b, float radius_a, float radius_b) {
  const glm::vec3 axis = b - a;
  const float length = glm::length(axis);
  const Quat<float> turn = rotation_between(glm::vec3(0, 1, 0), axis / length);
  Primitive part = showcase::lathe(
      {0, -radius_a, 0}, length + radius_a + radius_b,
      [=](float v) {
        const float y = v * (length + radius_a + radius_b) - radius_a, t = glm::clamp(y / length, 0.0f, 1.0f);
        const float r = radius_a + (radius_b - radius_a) * t;
        const float beyond = y < 0.0f ? y / radius_a : y > length ? (y - length) / radius_b : 0.0f;
        return r * std::sqrt(std::max(0.0f, 1.0f - beyond * beyond));
      },
      24, 32);
  for (glm::vec3& p : part.positions) p = a + turn * p;
  for (glm::vec3& n : part.normals) n = turn * n;
  return part;
}

struct Surface {
  Primitive whole;

  void add(std::uint16_t joint, const Primitive& part) {
    showcase::append(whole, part);
    whole.influences.joints.insert(whole.influences.joints.end(), part.vertex_count(), joint);
  }
};

void add_torso(const Build& build, const std::array<glm::vec3, kJoints>& at, Surface& surface) {
  const float w = build.thickness, chest = 0.75f * build.shoulders;
  const glm::vec3 top = at[spine] + glm::vec3(0, 0.78f * build.spine, 0);
  surface.add(hips, capsule(at[left_thigh], at[right_thigh], 0.085f * w, 0.085f * w));
  surface.add(spine, capsule(at[spine], top, 0.09f * w, std::max(chest, 0.1f * w)));
  surface.add(spine, capsule(at[left_arm], at[right_arm], 0.06f * w, 0.06f * w));
  surface.add(neck, capsule(at[neck], at[head], 0.045f * w, 0.04f * w));
  surface.add(head, showcase::sphere(at[head] + glm::vec3(0, 0.8f * build.head, 0.01f), build.head));
  surface.add(head, showcase::sphere(at[head] + glm::vec3(0, 0.75f * build.head, build.head), 0.18f * build.head));
}

void add_limbs(const Build& build, const std::array<glm::vec3, kJoints>& at, Surface& surface) {
  const float w = build.thickness;
  for (std::uint32_t side = 0; side < 2; ++side) {
    const auto limb = [&](Joint from, Joint to, float a, float b) {
      const auto joint = static_cast<std::uint16_t>(from + side);
      surface.add(joint, capsule(at[joint], at[static_cast<std::size_t>(to + side)], a * w, b * w));
    };
    limb(left_thigh, left_shank, 0.085f, 0.055f);
    limb(left_shank, left_foot, 0.055f, 0.04f);
    limb(left_foot, left_toes, 0.042f, 0.03f);
    limb(left_arm, left_forearm, 0.055f, 0.042f);
    limb(left_forearm, left_hand, 0.042f, 0.03f);
    const auto hand = static_cast<std::uint16_t>(left_hand + side);
    const glm::vec3 finger(side == 0 ? 0.3f : -0.3f, 0, 0);
    surface.add(hand, capsule(at[hand], at[hand] + finger * build.forearm, 0.035f * w, 0.028f * w));
  }
}

}  // namespace

const std::array<BodyJoint, kJoints>& body_joints() {
  static constexpr std::array<BodyJoint, kJoints> kAll = {BodyJoint{"Hips", kNone, 0},
                                                          {"Spine", hips, 1},
                                                          {"LeftUpLeg", hips, 1},
                                                          {"RightUpLeg", hips, 1},
                                                          {"Neck", spine, 2},
                                                          {"LeftArm", spine, 2},
                                                          {"RightArm", spine, 2},
                                                          {"LeftLeg", left_thigh, 2},
                                                          {"RightLeg", right_thigh, 2},
                                                          {"Head", neck, 3},
                                                          {"LeftForeArm", left_arm, 3},
                                                          {"RightForeArm", right_arm, 3},
                                                          {"LeftFoot", left_shank, 3},
                                                          {"RightFoot", right_shank, 3},
                                                          {"LeftHand", left_forearm, 4},
                                                          {"RightHand", right_forearm, 4},
                                                          {"LeftToeBase", left_foot, 4},
                                                          {"RightToeBase", right_foot, 4}};
  return kAll;
}

std::array<Transform, kJoints> rest_of(const Build& build) {
  std::array<Transform, kJoints> rest;
  const std::array<glm::vec3, kJoints> places = t_pose(build);
  for (std::uint32_t j = 0; j < kJoints; ++j) rest[j].translation = places[j];
  rest[left_arm].rotation = about({0, 0, 1}, -build.arms_down_rad);
  rest[right_arm].rotation = about({0, 0, 1}, build.arms_down_rad);
  return rest;
}

Scene make_body(const Build& build) {
  showcase::SceneBuilder scene;
  const std::array<Transform, kJoints> rest = rest_of(build);
  for (std::uint32_t j = 0; j < kJoints; ++j) scene.add_joint(body_joints()[j].name, body_joints()[j].parent, rest[j]);
  return scene.finish();
}

void dress(const Build& build, const std::array<std::uint32_t, kJoints>& joints, std::uint32_t holder,
           showcase::SceneBuilder& scene) {
  const std::array<glm::vec3, kJoints> at = places_in_t_pose(build);
  Surface surface;
  add_torso(build, at, surface);
  add_limbs(build, at, surface);
  Primitive& body = surface.whole;
  const auto vertices = static_cast<std::uint32_t>(body.vertex_count());
  body.influences.weights.assign(vertices, 1.0f);
  body.influences.groups = {{0, vertices, 1, 0}};
  body.material = scene.add_material(build.name, build.color, 0.5f);
  Skin skin{build.name, {joints.begin(), joints.end()}, std::vector<Affine>(kJoints), kNone};
  for (std::uint32_t j = 0; j < kJoints; ++j) {
    skin.inverse_bind[j].row[0].w = -at[j].x;
    skin.inverse_bind[j].row[1].w = -at[j].y;
    skin.inverse_bind[j].row[2].w = -at[j].z;
  }
  const std::uint32_t made = scene.add_skin(std::move(skin));
  scene.add_instance(holder, scene.add_mesh({build.name, {std::move(body)}, {}, {}}), made);
}

Animation make_run(const Build& build) {
  constexpr int kKeys = 24;
  std::array<BoneAnimation, kJoints> bones;
  for (int k = 0; k <= kKeys; ++k) {
    const float time_s = static_cast<float>(kRun_s) * static_cast<float>(k) / kKeys;
    const float phase = 2.0f * std::numbers::pi_v<float> * static_cast<float>(k) / kKeys;
    const auto turn = [&](std::uint32_t joint, const Quat<float>& rotation) {
      bones[joint].rotation.times_s.push_back(time_s);
      bones[joint].rotation.values.push_back(glm::normalize(rotation));
    };
    turn(spine, about_x(0.22f) * about({0, 1, 0}, 0.3f * std::sin(phase)));
    turn(head, about_x(-0.15f) * about({0, 1, 0}, -0.25f * std::sin(phase)));
    for (const std::uint32_t side : {0u, 1u}) {
      const float own = phase + (side == 0 ? 0.0f : std::numbers::pi_v<float>), s = std::sin(own), c = std::cos(own);
      const float outward = side == 0 ? 1.0f : -1.0f;
      turn(left_thigh + side, about_x(-0.35f - 0.75f * s));
      turn(left_shank + side, about_x(0.85f - 0.55f * s + 0.35f * c));
      turn(left_foot + side, about_x(-0.1f + 0.35f * std::max(0.0f, -s)));
      turn(left_arm + side, about_x(0.1f + 0.9f * s) * about({0, 0, 1}, -1.15f * outward));
      turn(left_forearm + side, about({0, 1, 0}, -1.35f * outward));
    }
    bones[hips].translation.times_s.push_back(time_s);
    bones[hips].translation.values.push_back(rest_of(build)[hips].translation +
                                             glm::vec3(0, 0.05f * std::cos(2.0f * phase) - 0.03f, 0));
  }
  Animation run{"run", kRun_s, {}, {}};
  for (std::uint32_t j = 0; j < kJoints; ++j) {
    bones[j].joint = j;
    if (!bones[j].empty()) run.bones.push_back(std::move(bones[j]));
  }
  return run;
}
