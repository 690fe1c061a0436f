// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/procedures/places.h"
#include "runtime/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

// The setup of springs (springs.h): joints that swing, in groups, and the shapes that they collide with.

typedef enum sinew_collider_kind {
  SINEW_COLLIDER_SPHERE = 0,
  SINEW_COLLIDER_CAPSULE = 1,
  SINEW_COLLIDER_PLANE = 2
} sinew_collider_kind;

/// A shape that keeps the tails of springs outside, or inside. This struct never grows.
typedef struct sinew_spring_collider {
  uint32_t kind;       ///< sinew_collider_kind
  uint32_t joint;      ///< that it moves with
  sinew_point offset;  ///< center, first end of a capsule, or a point of the plane; space of the joint
  sinew_point tail;    ///< capsule: the second end
  sinew_point normal;  ///< plane: points to the free side
  double radius_m;     ///< in the world: the scale of the joint does not change it
  uint32_t inside;     ///< 1: a sphere or capsule keeps tails inside
} sinew_spring_collider;

typedef enum sinew_spring_goal {
  SINEW_SPRING_TO_REST = 0,  ///< stiffness pulls to the rest rotation, as in VRM
  SINEW_SPRING_TO_POSE = 1   ///< stiffness pulls to the animated rotation
} sinew_spring_goal;

/// Values that all joints of one spring share. This struct never grows.
typedef struct sinew_spring_group {
  uint32_t center;            ///< joint relative to which inertia is computed; SINEW_NONE = the world
  uint32_t goal;              ///< sinew_spring_goal
  const uint32_t* colliders;  ///< indices into the colliders of the setup, tested in this order
  size_t collider_count;
} sinew_spring_group;

/// A joint that swings about its origin. Its tail is a point mass at a fixed distance. This struct never grows.
typedef struct sinew_spring_joint {
  uint32_t joint;
  uint32_t group;           ///< index into the groups of the setup
  sinew_point tail_m;       ///< place of the tail in the space of the joint, usually the translation of its child
  double stiffness;         ///< pull towards the goal: metres per second, added every 1/60 s
  double drag;              ///< [0, 1] part of the velocity that is lost in 1/60 s
  sinew_point gravity_m_s;  ///< metres per second, added every 1/60 s
  double hit_radius_m;      ///< radius of the tail for collisions
  uint32_t lagging_length;  ///< 1: the tail's distance follows its previous place, as in VRM 1.0; 0: it is the bone's
} sinew_spring_joint;

typedef struct sinew_springs_setup {
  size_t struct_size;
  const sinew_spring_group* groups;  ///< all lists are copied
  size_t group_count;
  const sinew_spring_joint* joints;  ///< each joint at most once
  size_t joint_count;
  const sinew_spring_collider* colliders;
  size_t collider_count;
  double tick_s;           ///< > 0; characters are tuned at 1/60 s
  uint32_t max_ticks;      ///< >= 1: most ticks of one frame; time beyond is dropped
  uint32_t sleep_ticks;    ///< quiet ticks after which springs sleep
  double sleep_rad_per_s;  ///< slower joints are quiet; 0 = springs never sleep
} sinew_springs_setup;

/// A setup without springs. All settings have their default values.
SINEW_API sinew_springs_setup sinew_default_springs_setup(void);
/// Stiffness 1, drag 0.4, no gravity.
SINEW_API sinew_spring_joint sinew_default_spring_joint(uint32_t joint);

#ifdef __cplusplus
}
#endif
