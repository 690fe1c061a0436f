// SPDX-License-Identifier: MIT
#include "runtime/procedures/constraints/node_constraints.h"

#include "runtime/math/interpolate.h"
#include "runtime/math/inverse.h"
#include "runtime/math/rotation_between.h"
#include "runtime/pose/exact_joint.h"

namespace sinew {
namespace {

using Rotation = Quat<double>;
using Point = Vec3<double>;

Rotation rest_of(const Skeleton& skeleton, std::uint32_t joint) noexcept {
  return normalised(quat_cast<double>(skeleton.rest[joint].rotation));
}

Rotation aim_goal(const NodeConstraintsJob& job, const NodeConstraint& constraint, const Rotation& rest) noexcept {
  const std::uint32_t parent = job.skeleton->parents[constraint.joint];
  const auto to_parent = inverse_of(exact_model_matrix(*job.skeleton, job.pose, parent));
  if (!to_parent) return rest;
  const Point source =
      transform_point(*to_parent, translation_of(exact_model_matrix(*job.skeleton, job.pose, constraint.source)));
  const Point to_source = source - Point(job.pose.get(constraint.joint).translation);
  return rotation_between(rotate_vector(rest, constraint.axis), to_source) * rest;
}

Rotation goal_of(const NodeConstraintsJob& job, const NodeConstraint& constraint, const Rotation& rest) noexcept {
  if (constraint.kind == NodeConstraint::Kind::aim) return aim_goal(job, constraint, rest);
  const Rotation source_rest = rest_of(*job.skeleton, constraint.source);
  const Rotation source = normalised(quat_cast<double>(job.pose.get(constraint.source).rotation));
  const Rotation turn = quat_conjugate(source_rest) * source;
  if (constraint.kind == NodeConstraint::Kind::rotation) return rest * turn;
  const Rotation to_joint = quat_conjugate(rest) * source_rest;
  const Rotation here = to_joint * turn * quat_conjugate(to_joint);
  return rest * quat_conjugate(rotation_between(constraint.axis, rotate_vector(here, constraint.axis))) * here;
}

void run_constraints(void* context, const ProcedurePose& pose) {
  // A procedure's context is not const, but this function only reads it.
  const auto* constraints = static_cast<const NodeConstraints*>(context);
  (void)run(NodeConstraintsJob{constraints, &pose.skeleton, pose.local, pose.share});
}

}  // namespace

ErrorCode check(const NodeConstraintsJob& job) noexcept {
  if (!job.constraints || !job.skeleton) return ErrorCode::size_mismatch;
  const std::size_t joints = job.constraints->skeleton_joint_count();
  if (job.skeleton->joint_count() != joints || !is_pose_of(job.pose, joints)) return ErrorCode::size_mismatch;
  return job.share >= 0.0f && job.share <= 1.0f ? ErrorCode::ok : ErrorCode::not_a_fraction;
}

void run_unchecked(const NodeConstraintsJob& job) noexcept {
  for (const NodeConstraint& constraint : job.constraints->ordered()) {
    const Rotation rest = rest_of(*job.skeleton, constraint.joint);
    Rotation result = slerp_short_arc(rest, normalised(goal_of(job, constraint, rest)), constraint.weight);
    if (job.share != 1.0f) {
      const Rotation pose = normalised(quat_cast<double>(job.pose.get(constraint.joint).rotation));
      result = slerp_short_arc(pose, result, static_cast<double>(job.share));
    }
    job.pose.set_rotation(constraint.joint, quat_cast<float>(normalised(result)));
  }
}

PoseProcedure constraints_procedure(const NodeConstraints& constraints) noexcept {
  return {&run_constraints, const_cast<NodeConstraints*>(&constraints), 1};
}

}  // namespace sinew
