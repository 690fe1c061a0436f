// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/animation/skeleton.h"  // kNone
#include "runtime/math/conventions.h"

namespace sinew {

/// A morph weight that an expression sets. Weights of the expressions that are on add up.
struct VrmMorphBind {
  std::uint32_t instance = kNone;  ///< into Scene::instances
  std::uint32_t target = 0;
  float weight = 1.0f;  ///< 0 to 1
};

/// A face, or a part of one: a preset such as "happy", "blink" and "aa", or one of the file's own.
struct VrmExpression {
  std::string name;
  bool is_preset = false;
  bool is_binary = false;  ///< on or off, nothing between
  std::vector<VrmMorphBind> morphs;
};

/// What turns the eyes to a point: the eye bones, or the expressions lookLeft, lookRight, lookUp and lookDown.
struct VrmLookAt {
  enum class Kind : std::uint8_t { none, bones, expressions };
  Kind kind = Kind::none;
  glm::vec3 offset_from_head_m{0.0f};  ///< where the eyes are, in the space of the bone "head"
};

/// A body that hair and cloth do not enter: a sphere, a capsule from `offset` to `tail`, or the space below a plane.
struct VrmCollider {
  enum class Kind : std::uint8_t { sphere, capsule, plane };
  Kind kind = Kind::sphere;
  std::uint32_t joint = kNone;
  glm::vec3 offset_m{0.0f}, tail_m{0.0f};  ///< in the joint's space
  glm::vec3 normal{0.0f, 1.0f, 0.0f};      ///< of a plane
  float radius_m = 0.0f;
  bool inside = false;  ///< of a sphere or capsule: the tails stay in it
};

struct VrmSpringJoint {
  std::uint32_t joint = kNone;
  float hit_radius_m = 0.0f, stiffness = 1.0f, gravity_power = 0.0f, drag_force = 0.5f;
  glm::vec3 gravity_direction{0.0f, -1.0f, 0.0f};
};

/// A chain of joints that swings, from its root to its tail. In VRM 0 it has one joint, and all below swing with it.
struct VrmSpring {
  std::string name;
  std::uint32_t center = kNone;  ///< joint whose movement causes no swing; kNone = the world
  std::vector<VrmSpringJoint> joints;
  std::vector<std::uint32_t> colliders;  ///< into VrmCharacter::colliders
};

/// A joint whose rotation follows another one (VRMC_node_constraint).
struct VrmConstraint {
  enum class Kind : std::uint8_t { roll, aim, rotation };
  Kind kind = Kind::rotation;
  std::uint32_t joint = kNone, source = kNone;
  glm::vec3 axis{0.0f};  ///< of a roll or an aim, in the joint's space
  float weight = 1.0f;
};

/// What a file says in VRM 0.x or 1.0 about the character that its scene shows (VRM, VRMC_vrm, VRMC_springBone,
/// VRMC_node_constraint), or about the character that its clips move (VRMC_vrm_animation). Nothing here is played yet.
struct VrmCharacter {
  std::string version;  ///< of the specification: "0.0", "1.0"
  std::string name, authors;
  bool is_animation = false;  ///< VRMC_vrm_animation: bones name what the clips move
  std::vector<NamedBone> bones;
  std::vector<VrmExpression> expressions;
  VrmLookAt look_at;
  std::vector<VrmCollider> colliders;
  std::vector<VrmSpring> springs;
  std::vector<VrmConstraint> constraints;
};

}  // namespace sinew
