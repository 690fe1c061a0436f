// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/animation/skeleton.h"
#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/pose/pose.h"
#include "runtime/procedures/ik_result.h"
#include "runtime/procedures/joint_limit.h"

namespace sinew {

enum class ChainSolver : std::uint8_t {
  ccd,     ///< each joint, from the last to the first, turns its effectors to their targets; converges slowly
  fabrik,  ///< moves positions of joints to the targets and back, then turns joints to fit; fast to a rough solution
  damped,  ///< damped least squares over all joints; exact after about eight iterations, which cost most
};

/// A joint that may turn.
struct ChainIkJoint {
  std::uint32_t joint = 0;
  std::uint32_t limit = kNone;  ///< index into ChainGoal::limits
  bool moves = false;           ///< its translation may change too, as for the hips of a body whose feet stand still
};

/// A joint with a target.
struct ChainEffector {
  std::uint32_t joint = 0;
  Vec3<double> target{0.0};                    ///< in model space
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};  ///< in model space, w x y z; unit
  float weight = 1.0f;  ///< >= 0, of the target. If two cannot both be reached, one with 100 times the weight nearly is
  float rotation_weight = 0.0f;  ///< >= 0, of `rotation`; 0: any rotation will do
};

/// Joints, targets, and limits of the solver. Bone lengths are taken from the pose, so they may be animated.
struct ChainGoal {
  std::span<const ChainIkJoint> joints;  ///< increasing
  std::span<const JointLimit> limits = {};
  std::span<const ChainEffector> effectors;  ///< at most 64
  ChainSolver solver = ChainSolver::fabrik;
  std::uint32_t iterations = 16;  ///< most iterations
  float most_turn_rad = 0.0f;     ///< largest turn of a joint in one iteration; 0: the solver's own bound
  float tolerance = 1e-4f;        ///< metres that count as reached
  float tolerance_rad = 1e-3f;
  float weight = 1.0f;  ///< [0, 1] mixes the pose before and after; 0 keeps every bit of the pose
};

/// Bytes of memory that a job with this goal needs, a multiple of 64.
/// in   goal  only the numbers of joints, limits and effectors, and the solver are used
SINEW_API std::size_t chain_ik_bytes(const Skeleton& skeleton, const ChainGoal& goal) noexcept;

/// Inverse kinematics of any number of joints, with several effectors on one skeleton: an arm, a tail, a whole body.
/// eq   ccd     q = the rotation with the least sum of w |q p - t|^2 (Davenport 1968), the smallest if there are many
///      fabrik  Aristidou and Lasenby 2011, with the mean of all proposals where chains meet
///      damped  (J J^T + l^2) y = e, turn = J^T y, with l by Levenberg's and Marquardt's rule, after one iteration of
///              ccd: far from the target the linear system leads astray
///      Turns are found in the space of each joint's parent, so parents may have any scale. After each turn a limit
///      brings the joint back. A chain that is straight towards its target is bent a little first.
/// in   memory  chain_ik_bytes, 64-byte aligned
/// out  local   rotations of goal.joints; translations of the joints with `moves`
///      result  may be null. Status `limited`: limits or the number of iterations stopped the solver. `unreachable`:
///      the bones from the first joint to an effector are too short
/// err  size_mismatch (pose, memory), index_out_of_range, parents_not_first (joints do not increase), unsupported (no
///      joint, a fixed matrix, an effector that no joint moves, more than 64), not_finite, not_normalised,
///      not_a_fraction (weight), negative_weight (other weights, tolerances), and those of the limits
/// cost O(J) once; an iteration O(n d) for n joints with d joints below, with `damped` O(n m^2) for m numbers of the
///      targets; no allocation
struct ChainIkJob {
  const Skeleton* skeleton = nullptr;
  PoseSpan local;
  ChainGoal goal;
  std::span<std::byte> memory;
  IkResult* result = nullptr;
};

SINEW_API ErrorCode check(const ChainIkJob& job) noexcept;
SINEW_API void run_unchecked(const ChainIkJob& job) noexcept;

}  // namespace sinew
