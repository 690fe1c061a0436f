// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/base/index.h"
#include "runtime/math/conventions.h"
#include "runtime/math/quaternion.h"
#include "runtime/math/transform.h"
#include "runtime/procedures/springs/spring_setup.h"

namespace sinew {

namespace springs {

/// The local transform of a record in a frame, ready for ticks.
struct JointInput {
  Vec3<double> translation;
  Quat<double> goal;  ///< rest or animated rotation, unit
  Vec3<double> scale;
  Vec3<double> bone;  ///< the tail, scaled
  Vec3<double> axis;  ///< its direction
  double length;
};

}  // namespace springs

/// A joint that springs compute: it swings, or it is carried between two that swing.
struct SpringRecord {
  std::uint32_t joint = 0;
  std::uint32_t parent = kNone;  ///< an earlier record; kNone = the joint hangs on `frame`
  std::uint32_t frame = kNone;   ///< into SpringTables::frames: the joint above the whole chain
  std::uint32_t group = kNone;   ///< kNone = carried
  std::uint32_t setup = kNone;   ///< index of the joint in the setup
  SpringGoal goal = SpringGoal::pose;
  Quat<double> rest = quat_identity<double>();  ///< used for SpringGoal::rest
  Vec3<double> tail{0.0}, axis{0.0, 1.0, 0.0};  ///< and its direction
  double length = 0.0;                          ///< of the tail
  double kept = 0.0;                            ///< part of the velocity that a tick keeps
  double pull = 0.0;                            ///< metres that stiffness moves the tail in a tick
  Vec3<double> gravity{0.0};                    ///< metres that gravity moves the tail in a tick
  double hit_radius = 0.0;
  bool lagging = false;  ///< SpringJoint::lagging_length
};

/// A joint whose transform springs read and do not change: they hang on it, or a collider or centre does.
struct SpringInputFrame {
  std::uint32_t ancestor = kNone;  ///< into SpringTables::ancestors; kNone = the root
};

/// A joint above a frame, which is composed once a frame.
struct SpringAncestor {
  std::uint32_t joint = 0;
  std::uint32_t parent = kNone;  ///< an earlier ancestor; kNone = the root
};

struct SpringGroupRecord {
  std::uint32_t center = kNone;                          ///< into SpringTables::frames
  std::uint32_t first_collider = 0, collider_count = 0;  ///< into SpringTables::collider_lists
};

struct SpringColliderRecord {
  SpringCollider shape;
  std::uint32_t frame = 0;  ///< into SpringTables::frames
};

/// Everything that SpringsJob reads of a definition, in the order of the skeleton.
struct SpringTables {
  std::vector<SpringRecord> records;
  std::vector<SpringAncestor> ancestors;
  std::vector<SpringInputFrame> frames;
  std::vector<SpringGroupRecord> groups;
  std::vector<SpringColliderRecord> colliders;  ///< those that groups use
  std::vector<std::uint32_t> collider_lists;
  bool has_carried = false;                      ///< some records are carried
  std::vector<Transform> rest;                   ///< [records]
  std::vector<springs::JointInput> rest_inputs;  ///< [records] of joints at rest
  bool is_rest_uniform = true;                   ///< no rest scale shears
};

}  // namespace sinew
