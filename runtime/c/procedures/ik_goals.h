// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/procedures/places.h"
#include "runtime/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

// Goals of inverse kinematics (ik.h). Places and directions are in model space, below sinew_frame_input.root. Angles
// are in radians.

typedef enum sinew_pole_kind {
  SINEW_POLE_NONE = 0,       ///< the limb stays in the plane in which the pose bends it
  SINEW_POLE_DIRECTION = 1,  ///< the middle joint points in this direction
  SINEW_POLE_POINT = 2,      ///< the middle joint points towards this place
  SINEW_POLE_TIP_AXIS = 3    ///< the middle joint points along a direction in the space of the tip, as of a foot
} sinew_pole_kind;

typedef enum sinew_end_rotation {
  SINEW_END_FOLLOWS = 0,  ///< the tip turns with the bone before it
  SINEW_END_KEEPS = 1,    ///< the tip keeps its rotation in model space
  SINEW_END_GIVEN = 2     ///< the tip takes `end_rotation`
} sinew_end_rotation;

typedef enum sinew_ik_blend {
  SINEW_BLEND_ROTATIONS = 0,  ///< a weight below 1 mixes the rotations before and after solving
  SINEW_BLEND_EFFECTOR = 1    ///< a weight below 1 moves the tip only part of the straight line to the target
} sinew_ik_blend;

typedef enum sinew_chain_solver {
  SINEW_SOLVER_CCD = 0,
  SINEW_SOLVER_FABRIK = 1,
  SINEW_SOLVER_DAMPED = 2  ///< damped least squares
} sinew_chain_solver;

/// A limb of three joints: `middle` is below `root`, and `tip` is below `middle`.
typedef struct sinew_two_bone_goal {
  size_t struct_size;
  uint32_t root, middle, tip;
  uint32_t pole_kind;  ///< sinew_pole_kind
  sinew_point target, pole;
  uint32_t blend;           ///< sinew_ik_blend
  uint32_t end;             ///< sinew_end_rotation
  sinew_vec4 end_rotation;  ///< unit quaternion x y z w
  sinew_vec3 middle_axis;   ///< hinge in the space of the middle joint; zero: the axis about which the pose bends
  float twist_rad, weight;  ///< weight: [0, 1]
  float soft_reach;         ///< [0, 1) share of the limb's length over which it straightens smoothly; 0 = off
  float most_stretch;       ///< >= 1: factor by which bones may lengthen; 1 = off
  float least_bend_rad, most_bend_rad;
  float pole_fade;  ///< [0, 1) sine of the angle between pole and target below which the pole fades; 0 = never
  float tolerance;  ///< distance that counts as reached, as a share of the limb's length
} sinew_two_bone_goal;

/// How far a joint may turn. This struct never grows.
typedef struct sinew_joint_limit {
  sinew_vec4 center;  ///< local rotation at the center of the allowed range
  sinew_vec4 axes;    ///< unit rotation from axes of the limit to the space of the joint; its x axis is the bone
  float swing_y_rad, swing_z_rad;  ///< largest swing about the axes y and z; [0, 2.8]
  float least_twist_rad, most_twist_rad;
  uint32_t limits_swing, limits_twist;  ///< 0 or 1; 0 allows every swing or twist
} sinew_joint_limit;

/// A joint that takes part in an aim. This struct never grows.
typedef struct sinew_aim_joint {
  uint32_t joint;
  float share;
  uint32_t limit;  ///< index into the limits of the goal, or SINEW_NONE
} sinew_aim_joint;

typedef struct sinew_aim_goal {
  size_t struct_size;
  const sinew_aim_joint* joints;  ///< each joint is below the previous one; copied
  size_t joint_count;
  const sinew_joint_limit* limits;  ///< copied
  size_t limit_count;
  sinew_point target;
  sinew_vec3 forward, up, offset;  ///< line that aims, its up direction and start, in the last joint's space
  sinew_point pole;                ///< direction in model space to which `up` turns; zero = the joints do not roll
  float twist_rad, weight, pole_fade, tolerance_rad;
} sinew_aim_goal;

/// A joint that may turn. This struct never grows.
typedef struct sinew_chain_joint {
  uint32_t joint;
  uint32_t limit;  ///< index into the limits of the goal, or SINEW_NONE
  uint32_t moves;  ///< 1: its translation may change, too
} sinew_chain_joint;

/// A joint with a target. This struct never grows.
typedef struct sinew_chain_effector {
  uint32_t joint;
  sinew_point target;
  sinew_vec4 rotation;  ///< unit quaternion x y z w
  float weight;
  float rotation_weight;  ///< 0: only the place matters
} sinew_chain_effector;

typedef struct sinew_chain_goal {
  size_t struct_size;
  const sinew_chain_joint* joints;  ///< by increasing index; copied
  size_t joint_count;
  const sinew_joint_limit* limits;  ///< copied
  size_t limit_count;
  const sinew_chain_effector* effectors;  ///< copied
  size_t effector_count;
  uint32_t solver;  ///< sinew_chain_solver
  uint32_t iterations;
  float most_turn_rad;
  float tolerance;  ///< metres that count as reached
  float tolerance_rad, weight;
} sinew_chain_goal;

/// Goals without joints. All numbers have their default values.
SINEW_API sinew_two_bone_goal sinew_default_two_bone_goal(void);
SINEW_API sinew_aim_goal sinew_default_aim_goal(void);
SINEW_API sinew_chain_goal sinew_default_chain_goal(void);

#ifdef __cplusplus
}
#endif
