// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <string>

#include "runtime/animation/bone_animation.h"
#include "samples/showcase/scene_builder.h"

// Procedural mannequins with Mixamo joint names: joints, a skin of rounded limbs, and a run cycle.

/// Proportions, in metres; the rest pose has its arms lowered by `arms_down_rad` from a T-pose.
struct Build {
  const char* name;
  float thigh, shank, foot, spine, neck, shoulders, upper_arm, forearm, head, thickness, arms_down_rad;
  glm::vec3 color;
};

inline constexpr std::array<Build, 3> kBuilds = {
    Build{"small", 0.26f, 0.24f, 0.14f, 0.42f, 0.12f, 0.17f, 0.20f, 0.19f, 0.17f, 1.15f, 0.0f, {0.80f, 0.35f, 0.18f}},
    Build{"tall", 0.56f, 0.54f, 0.20f, 0.50f, 0.16f, 0.20f, 0.36f, 0.34f, 0.12f, 0.85f, 0.8f, {0.18f, 0.42f, 0.68f}},
    Build{"broad", 0.40f, 0.38f, 0.20f, 0.62f, 0.14f, 0.34f, 0.36f, 0.32f, 0.14f, 1.7f, 0.3f, {0.42f, 0.52f, 0.24f}}};

inline constexpr std::uint32_t kJoints = 18;

/// Joints ordered by depth, so that several bodies can be added to one scene level by level.
struct BodyJoint {
  const char* name;
  std::uint32_t parent, level;
};
const std::array<BodyJoint, kJoints>& body_joints();

/// Rest transforms of the joints.
std::array<sinew::Transform, kJoints> rest_of(const Build& build);

/// A scene of one body, without clips.
sinew::Scene make_body(const Build& build);

/// Adds the surface of a body whose joints have been added.
void dress(const Build& build, const std::array<std::uint32_t, kJoints>& joints, std::uint32_t holder,
           sinew::showcase::SceneBuilder& scene);

/// A run in place for that body: two steps in 0.8 s.
sinew::Animation make_run(const Build& build);
