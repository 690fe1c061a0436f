// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/base/index.h"
#include "runtime/math/conventions.h"
#include "runtime/math/quaternion.h"
#include "runtime/math/transform.h"
#include "runtime/procedures/springs/spring_setup.h"
#include "runtime/procedures/springs/spring_slots.h"

namespace sinew {

namespace springs {

/// Local transform of a record's joint in a frame, prepared for ticks.
struct JointInput {
  Vec3<double> translation;
  Quat<double> goal;  ///< rest or animated rotation, unit
  Vec3<double> scale;
  Vec3<double> bone;  ///< vector to the tail, scaled
  Vec3<double> axis;  ///< unit direction of `bone`
  double length;
};

}  // namespace springs

/// A joint that springs compute. It either swings, or it lies between two swinging joints and is carried along.
struct SpringRecord {
  std::uint32_t joint = 0;
  std::uint32_t parent = kNone;  ///< an earlier record; kNone = the joint is a child of `frame`
  std::uint32_t frame = kNone;   ///< index into SpringTables::frames: the joint above the whole chain
  std::uint32_t group = kNone;   ///< kNone = the joint is carried along
  std::uint32_t setup = kNone;   ///< index of the joint in SpringSetup::joints
  SpringGoal goal = SpringGoal::pose;
  Quat<double> rest = quat_identity<double>();  ///< used for SpringGoal::rest
  Vec3<double> tail{0.0}, axis{0.0, 1.0, 0.0};  ///< vector to the tail, and its unit direction
  double length = 0.0;                          ///< of the tail
  double kept = 0.0;                            ///< factor of the velocity per tick, 1 - drag at 60 ticks per second
  double pull = 0.0;                            ///< metres per tick by which stiffness moves the tail
  Vec3<double> gravity{0.0};                    ///< metres per tick by which gravity moves the tail
  double hit_radius = 0.0;
  bool lagging = false;  ///< SpringJoint::lagging_length
};

/// A joint whose transform springs read but do not change: chains, colliders or centres are attached to it.
struct SpringInputFrame {
  std::uint32_t ancestor = kNone;  ///< index into SpringTables::ancestors; kNone = the root transform
};

/// A joint above an input frame. Its world transform is computed once per frame.
struct SpringAncestor {
  std::uint32_t joint = 0;
  std::uint32_t parent = kNone;  ///< an earlier ancestor; kNone = the root transform
};

struct SpringGroupRecord {
  std::uint32_t center = kNone;                          ///< into SpringTables::frames
  std::uint32_t first_collider = 0, collider_count = 0;  ///< into SpringTables::collider_lists
};

struct SpringColliderRecord {
  SpringCollider shape;
  std::uint32_t frame = 0;  ///< into SpringTables::frames
};

/// Records whose joints follow each other in the skeleton, so that planes of a pose are compared and copied at once.
struct SpringRun {
  std::size_t joint = 0, record = 0, count = 0;
  bool reads_rotations = false;   ///< SpringGoal::pose
  bool writes_rotations = false;  ///< the joints are those of the setup
};

/// All data of a definition that SpringsJob reads, in the order of the skeleton.
struct SpringTables {
  std::vector<SpringRecord> records;
  std::vector<SpringAncestor> ancestors;
  std::vector<SpringInputFrame> frames;
  std::vector<SpringGroupRecord> groups;
  std::vector<SpringColliderRecord> colliders;  ///< colliders that some group uses
  std::vector<std::uint32_t> collider_lists;
  std::vector<SpringRun> runs;  ///< all records
  std::vector<float> rest;      ///< [PoseSpan::plane_count][records] rest transforms as a pose stores them
  bool is_rest_uniform = true;  ///< no scale at rest shears joints
  springs::SpringSlots slots;
};

}  // namespace sinew
