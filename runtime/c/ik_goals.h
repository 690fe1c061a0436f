// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

// Goals of inverse kinematics (ik.h). Places and directions are in model space, below sinew_frame_input.root. Angles
// are in radians.

/// A place or direction. This struct never grows.
typedef struct sinew_point {
  double x, y, z;
} sinew_point;

typedef enum sinew_pole_kind {
  SINEW_POLE_NONE = 0,       ///< the plane in which the pose is bent is kept
  SINEW_POLE_DIRECTION = 1,  ///< the middle joint goes this way
  SINEW_POLE_POINT = 2,      ///< the middle joint goes towards this place
  SINEW_POLE_TIP_AXIS = 3    ///< a direction in the space of the tip, for example where the foot points
} sinew_pole_kind;

typedef enum sinew_end_rotation {
  SINEW_END_FOLLOWS = 0,  ///< the tip turns with the bone before it
  SINEW_END_KEEPS = 1,    ///< it keeps its rotation in model space
  SINEW_END_GIVEN = 2     ///< it takes `end_rotation`
} sinew_end_rotation;

typedef enum sinew_ik_blend {
  SINEW_BLEND_ROTATIONS = 0,  ///< a weight below 1 mixes the rotations before and after
  SINEW_BLEND_EFFECTOR = 1    ///< it moves the tip along a line towards the target
} sinew_ik_blend;

typedef enum sinew_chain_solver {
  SINEW_SOLVER_CCD = 0,
  SINEW_SOLVER_FABRIK = 1,
  SINEW_SOLVER_DAMPED = 2  ///< damped least squares
} sinew_chain_solver;

/// A limb of three joints, each below the one before.
typedef struct sinew_two_bone_goal {
  size_t struct_size;
  uint32_t root, middle, tip;
  uint32_t pole_kind;  ///< sinew_pole_kind
  sinew_point target, pole;
  uint32_t blend;           ///< sinew_ik_blend
  uint32_t end;             ///< sinew_end_rotation
  sinew_vec4 end_rotation;  ///< unit quaternion x y z w
  sinew_vec3 middle_axis;   ///< hinge in the space of the middle joint; zero: that of the pose
  float twist_rad, weight;  ///< weight: [0, 1]
  float soft_reach;         ///< [0, 1) share of the length that straightens slowly; 0 = off
  float most_stretch;       ///< >= 1; 1 = off
  float least_bend_rad, most_bend_rad;
  float pole_fade;  ///< sine of the angle to the pole below which the pole fades
  float tolerance;  ///< share of the length
} sinew_two_bone_goal;

/// How far a joint may turn. This struct never grows.
typedef struct sinew_joint_limit {
  sinew_vec4 center;               ///< local rotation in the middle
  sinew_vec4 axes;                 ///< in the space of the joint; their x is the bone
  float swing_y_rad, swing_z_rad;  ///< [0, 2.8]
  float least_twist_rad, most_twist_rad;
  uint32_t limits_swing, limits_twist;  ///< 0 or 1
} sinew_joint_limit;

/// A joint that takes part in an aim. This struct never grows.
typedef struct sinew_aim_joint {
  uint32_t joint;
  float share;
  uint32_t limit;  ///< index into the limits of the goal, or SINEW_NONE
} sinew_aim_joint;

typedef struct sinew_aim_goal {
  size_t struct_size;
  const sinew_aim_joint* joints;  ///< each below the one before; copied
  size_t joint_count;
  const sinew_joint_limit* limits;  ///< copied
  size_t limit_count;
  sinew_point target;
  sinew_vec3 forward, up, offset;  ///< in the space of the last joint
  sinew_point pole;                ///< to which `up` turns; zero = none
  float twist_rad, weight, pole_fade, tolerance_rad;
} sinew_aim_goal;

/// A joint that may turn. This struct never grows.
typedef struct sinew_chain_joint {
  uint32_t joint;
  uint32_t limit;  ///< index into the limits of the goal, or SINEW_NONE
  uint32_t moves;  ///< 1: it may move, too
} sinew_chain_joint;

/// A joint with a target. This struct never grows.
typedef struct sinew_chain_effector {
  uint32_t joint;
  sinew_point target;
  sinew_vec4 rotation;  ///< unit quaternion x y z w
  float weight;
  float rotation_weight;  ///< 0: the rotation is not asked for
} sinew_chain_effector;

typedef struct sinew_chain_goal {
  size_t struct_size;
  const sinew_chain_joint* joints;  ///< increasing; copied
  size_t joint_count;
  const sinew_joint_limit* limits;  ///< copied
  size_t limit_count;
  const sinew_chain_effector* effectors;  ///< copied
  size_t effector_count;
  uint32_t solver;  ///< sinew_chain_solver
  uint32_t iterations;
  float most_turn_rad;
  float tolerance;  ///< metres
  float tolerance_rad, weight;
} sinew_chain_goal;

/// Goals without joints, with all numbers at their defaults.
SINEW_API sinew_two_bone_goal sinew_default_two_bone_goal(void);
SINEW_API sinew_aim_goal sinew_default_aim_goal(void);
SINEW_API sinew_chain_goal sinew_default_chain_goal(void);

#ifdef __cplusplus
}
#endif
