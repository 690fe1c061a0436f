// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/animation/skeleton.h"
#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/pose/pose.h"
#include "runtime/pose_program/program_inputs.h"

namespace sinew {

/// A joint whose rotation follows another joint (VRMC_node_constraint 1.0).
struct NodeConstraint {
  enum class Kind : std::uint8_t {
    roll,      ///< copies the part of the source's turn that is about `axis`
    aim,       ///< turns the joint so that `axis` points to the source
    rotation,  ///< copies the source's turn since its rest
  };
  Kind kind = Kind::rotation;
  std::uint32_t joint = kNone, source = kNone;
  Vec3<double> axis{0.0};  ///< roll or aim axis in the space of the joint
  double weight = 1.0;     ///< [0, 1]
};

/// Constraints in order of evaluation: each comes after the constraints of joints that it reads. Immutable.
class SINEW_API NodeConstraints {
 public:
  std::span<const NodeConstraint> ordered() const noexcept { return ordered_; }
  std::size_t skeleton_joint_count() const noexcept { return joints_; }

 private:
  friend class ConstraintSorter;
  std::vector<NodeConstraint> ordered_;
  std::size_t joints_ = 0;
};

/// The constraint that cannot be used, and why: "constraints[2]: joint "a" follows "b", which follows "a"".
struct ConstraintFault {
  ErrorCode code = ErrorCode::ok;
  std::string text;
};

/// Sorts constraints by the joints that they read: the source. An aim also reads all joints above the source and above
/// the joint.
/// err  index_out_of_range   a joint or source does not exist, or a joint has two constraints
///      not_finite, not_a_fraction   an axis or a weight;  unsupported   an axis without a direction, a fixed matrix
///      follows_itself       constraints read each other in a circle, which the text names
/// cost O(constraints * depth), allocates
SINEW_API tl::expected<NodeConstraints, ConstraintFault> sort_constraints(const Skeleton& skeleton,
                                                                          std::span<const NodeConstraint> constraints);

/// Turns all constrained joints of a pose.
/// eq   d = rest(source)^-1 source, the turn of the source since its rest (VRMC_node_constraint 1.0)
///      rotation: goal = rest d
///      roll:     e = rest^-1 rest(source) d rest(source)^-1 rest;  goal = rest s^-1 e, s the shortest turn from the
///                axis to e(axis)
///      aim:      goal = s rest, s the shortest turn from rest(axis) to the direction of the source, in the parent's
///      space
///      result = slerp(rest, goal, weight). The joint's rotation in the pose is not read. If the source is at the same
///      place as the joint, an aim keeps the rest.
/// in   pose  [J of the skeleton] local transforms;   share  [0, 1] of the results in a mix with the pose
/// out  pose  rotations of constrained joints
/// err  size_mismatch, not_a_fraction     cost O(constraints), of aims O(depth); no allocation
struct NodeConstraintsJob {
  const NodeConstraints* constraints = nullptr;
  const Skeleton* skeleton = nullptr;
  PoseSpan pose;
  float share = 1.0f;
};

SINEW_API ErrorCode check(const NodeConstraintsJob& job) noexcept;
SINEW_API void run_unchecked(const NodeConstraintsJob& job) noexcept;

/// The job as a procedure of a pose program. Its output depends on the pose alone, so its version never changes.
/// in   constraints  must outlive the program's runs
SINEW_API PoseProcedure constraints_procedure(const NodeConstraints& constraints) noexcept;

}  // namespace sinew
