// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/animation/skeleton.h"  // kNone
#include "runtime/math/conventions.h"

namespace sinew {

/// A morph weight that an expression sets. Weights of active expressions add up.
struct VrmMorphBind {
  std::uint32_t instance = kNone;  ///< index into Scene::instances
  std::uint32_t target = 0;
  float weight = 1.0f;  ///< 0 to 1
};

/// A facial expression: a preset such as "happy", "blink" or "aa", or a custom one of the file.
struct VrmExpression {
  /// How this expression weakens the expressions of one part of the face.
  enum class Override : std::uint8_t {
    none,
    block,  ///< turns them off while its own value is above 0
    blend   ///< subtracts its own value from their factor
  };
  std::string name;
  bool is_preset = false;
  bool is_binary = false;  ///< fully on or off, without intermediate weights
  std::vector<VrmMorphBind> morphs;
  Override override_blink = Override::none, override_look_at = Override::none, override_mouth = Override::none;
  std::uint32_t value_joint = kNone;  ///< in VRMC_vrm_animation: the joint whose x translation is the value
};

/// How the eyes look at a point: with eye bones, or with the expressions lookLeft, lookRight, lookUp and lookDown.
struct VrmLookAt {
  enum class Kind : std::uint8_t { none, bones, expressions };
  /// How far eyes move: in proportion to the angle of the target, up to `most_input_deg`.
  struct Range {
    float most_input_deg = 90.0f;
    float output = 10.0f;  ///< degrees of bones, or the weight of an expression
  };
  Kind kind = Kind::none;
  /// Position between the eyes in the space of the bone "head". The default is that of UniVRM, for files without one.
  glm::vec3 offset_from_head_m{0.0f, 0.06f, 0.0f};
  Range inner, outer, down, up;      ///< towards the nose, away from it, down and up
  std::uint32_t gaze_joint = kNone;  ///< in VRMC_vrm_animation: the joint whose rotation is the direction of the gaze
};

/// A collider for hair and cloth: a sphere, a capsule from `offset` to `tail`, or the half-space below a plane.
struct VrmCollider {
  enum class Kind : std::uint8_t { sphere, capsule, plane };
  Kind kind = Kind::sphere;
  std::uint32_t joint = kNone;
  glm::vec3 offset_m{0.0f}, tail_m{0.0f};  ///< positions in the joint's space
  glm::vec3 normal{0.0f, 1.0f, 0.0f};      ///< used by planes only
  float radius_m = 0.0f;
  bool inside = false;  ///< sphere or capsule: keeps the tails inside instead of outside
};

struct VrmSpringJoint {
  std::uint32_t joint = kNone;
  float hit_radius_m = 0.0f, stiffness = 1.0f, gravity_power = 0.0f, drag_force = 0.5f;
  glm::vec3 gravity_direction{0.0f, -1.0f, 0.0f};
};

/// A swinging chain of joints, from root to tail. In VRM 0 it has one joint, and all joints below it swing, too.
struct VrmSpring {
  std::string name;
  std::uint32_t center = kNone;  ///< reference joint: moving with it causes no swing; kNone = world space
  std::vector<VrmSpringJoint> joints;
  std::vector<std::uint32_t> colliders;  ///< indices into VrmCharacter::colliders
};

/// A joint whose rotation follows another one (VRMC_node_constraint).
struct VrmConstraint {
  enum class Kind : std::uint8_t { roll, aim, rotation };
  Kind kind = Kind::rotation;
  std::uint32_t joint = kNone, source = kNone;
  glm::vec3 axis{0.0f};  ///< roll or aim axis, in the joint's space
  float weight = 1.0f;
};

/// VRM 0.x or 1.0 data of the scene's character (VRM, VRMC_vrm, VRMC_springBone, VRMC_node_constraint). For
/// VRMC_vrm_animation, of the character that the clips animate. vrm_springs.h makes springs and constraints of it.
struct VrmCharacter {
  std::string version;  ///< version of the specification: "0.0" or "1.0"
  std::string name, authors;
  std::string licence;        ///< VRM 0: the name of the licence; VRM 1: its address
  bool is_animation = false;  ///< VRMC_vrm_animation: `bones` are the targets of the clips
  std::vector<NamedBone> bones;
  std::vector<VrmExpression> expressions;
  VrmLookAt look_at;
  std::vector<VrmCollider> colliders;
  std::vector<VrmSpring> springs;
  std::vector<VrmConstraint> constraints;
};

}  // namespace sinew
