// SPDX-License-Identifier: MIT
#include "runtime/procedures/chain_ik.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "runtime/base/all_finite.h"
#include "runtime/math/axis_angle.h"
#include "runtime/math/rotation_between.h"
#include "runtime/procedures/chain/chain_tree.h"
#include "runtime/procedures/joint_frames.h"

namespace sinew {
namespace {

using V = Vec3<double>;
constexpr std::size_t kMostEffectors = 64;

bool is_met(const ChainGoal& goal, const ik::ChainErrors& errors) noexcept {
  return errors.metres <= static_cast<double>(goal.tolerance) &&
         errors.radians <= static_cast<double>(goal.tolerance_rad);
}

/// True if the bones between the first moving joint above an effector and the effector are shorter than the way to its
/// target.
bool is_beyond_reach(const ik::ChainTree& tree, std::size_t effector) noexcept {
  if (tree.goal().effectors[effector].weight == 0.0f) return false;
  double length = 0.0, reach = 0.0;
  std::uint32_t first = kNone;
  for (std::uint32_t n = tree.effectors[effector]; n != kNone; n = tree.nodes[n].parent) {
    if (tree.nodes[n].part != kNone) {
      if (tree.part(tree.nodes[n]).moves) return false;
      first = n;
      reach = length;
    }
    if (tree.nodes[n].parent != kNone) length += safe_length(tree.place(n) - tree.place(tree.nodes[n].parent));
  }
  return safe_length(tree.goal().effectors[effector].target - tree.place(first)) > reach * (1.0 + 1e-9);
}

/// True if every bone below a moving joint points at the target or away from it, so that no joint knows where to turn.
bool is_straight_to_target(const ik::ChainTree& tree, std::size_t effector) noexcept {
  const V target = tree.goal().effectors[effector].target, end = tree.place(tree.effectors[effector]);
  for (const std::uint32_t at : tree.moving) {
    if ((tree.nodes[at].effectors >> effector & 1) == 0) continue;
    const V arm = normalised_or(end - tree.place(at), V(0.0)), way = normalised_or(target - tree.place(at), V(0.0));
    if (safe_length(glm::cross(arm, way)) > 1e-6) return false;
  }
  return true;
}

/// Slightly bends chains that are straight towards a target nearer than their end. Otherwise no joint would know where
/// to turn.
void bend_straight_chains(ik::ChainTree& tree) noexcept {
  constexpr double kBend_rad = 0.05;
  for (std::size_t i = 0; i < tree.effectors.size(); ++i) {
    if (tree.goal().effectors[i].weight == 0.0f ||
        safe_length(tree.error(i).way) <= static_cast<double>(tree.goal().tolerance))
      continue;
    if (is_beyond_reach(tree, i) || !is_straight_to_target(tree, i)) continue;
    for (const std::uint32_t at : tree.moving) {
      const ik::ChainNode& node = tree.nodes[at];
      const auto back = inverse_of(tree.model_above(node));
      if ((node.effectors >> i & 1) == 0 || !back) continue;
      const V arm = transform_point(*back, tree.place(tree.effectors[i])) - node.local.translation;
      if (arm == V(0.0)) continue;
      tree.turn(at, quat_from_axis_angle(perpendicular_to(normalised_or(arm, V(1, 0, 0))), kBend_rad));
    }
    tree.update(0);
  }
}

/// Writes the solved pose, or the part of the way to it that the weight asks for.
void write(const ik::ChainTree& tree) noexcept {
  const ChainGoal& goal = tree.goal();
  for (const std::uint32_t at : tree.moving) {
    const ik::ChainNode& node = tree.nodes[at];
    const PoseSpan& local = tree.job.local;
    const Transformd before = local_of(local, node.joint);
    const double weight = static_cast<double>(goal.weight);
    write_rotation(local, node.joint, part_of_turn(normalised(before.rotation), node.local.rotation, weight));
    if (!tree.part(node).moves) continue;
    const Vec3<float> place(before.translation + (node.local.translation - before.translation) * weight);
    local.plane(PoseSpan::tx)[node.joint] = place.x;
    local.plane(PoseSpan::ty)[node.joint] = place.y;
    local.plane(PoseSpan::tz)[node.joint] = place.z;
  }
}

/// Reports the errors of the pose that was written.
void tell(ik::ChainTree& tree, std::uint32_t iterations, bool can_reach) noexcept {
  for (const std::uint32_t at : tree.moving) tree.nodes[at].local = local_of(tree.job.local, tree.nodes[at].joint);
  tree.update(0);
  const ik::ChainErrors errors = tree.errors();
  IkResult& result = *tree.job.result;
  result.iterations = iterations;
  result.metres_left = static_cast<float>(errors.metres);
  result.radians_left = static_cast<float>(errors.radians);
  result.status = is_met(tree.goal(), errors) ? IkStatus::reached
                  : can_reach                 ? IkStatus::limited
                                              : IkStatus::unreachable;
}

ErrorCode check_joints(const Skeleton& skeleton, const ChainGoal& goal) noexcept {
  if (goal.joints.empty() || goal.effectors.size() > kMostEffectors) return ErrorCode::unsupported;
  for (std::size_t i = 0; i < goal.joints.size(); ++i) {
    const ChainIkJoint& joint = goal.joints[i];
    if (joint.joint >= skeleton.joint_count()) return ErrorCode::index_out_of_range;
    if (joint.limit != kNone && joint.limit >= goal.limits.size()) return ErrorCode::index_out_of_range;
    if (i > 0 && joint.joint <= goal.joints[i - 1].joint) return ErrorCode::parents_not_first;
    if (!can_turn(skeleton, joint.joint)) return ErrorCode::unsupported;
    const auto moves = [&](const ChainEffector& effector) { return is_below(skeleton, effector.joint, joint.joint); };
    for (const ChainEffector& effector : goal.effectors)
      if (effector.joint >= skeleton.joint_count()) return ErrorCode::index_out_of_range;
    if (std::none_of(goal.effectors.begin(), goal.effectors.end(), moves)) return ErrorCode::unsupported;
  }
  for (const ChainEffector& effector : goal.effectors)
    if (std::none_of(goal.joints.begin(), goal.joints.end(),
                     [&](const ChainIkJoint& joint) { return is_below(skeleton, effector.joint, joint.joint); }))
      return ErrorCode::unsupported;
  return ErrorCode::ok;
}

ErrorCode check_numbers(const ChainGoal& goal) noexcept {
  for (const ChainEffector& effector : goal.effectors) {
    const glm::quat& q = effector.rotation;
    const float floats[] = {q.x, q.y, q.z, q.w, effector.weight, effector.rotation_weight};
    const double doubles[] = {effector.target.x, effector.target.y, effector.target.z};
    if (!all_finite(std::span<const float>(floats)) || !all_finite(std::span<const double>(doubles)))
      return ErrorCode::not_finite;
    if (effector.weight < 0.0f || effector.rotation_weight < 0.0f) return ErrorCode::negative_weight;
    if (std::abs(square_of(q) - 1.0f) > 1e-4f) return ErrorCode::not_normalised;
  }
  const float floats[] = {goal.most_turn_rad, goal.tolerance, goal.tolerance_rad, goal.weight};
  if (!all_finite(std::span<const float>(floats))) return ErrorCode::not_finite;
  if (!(goal.weight >= 0.0f && goal.weight <= 1.0f)) return ErrorCode::not_a_fraction;
  return std::min({goal.most_turn_rad, goal.tolerance, goal.tolerance_rad}) < 0.0f ? ErrorCode::negative_weight
                                                                                   : ErrorCode::ok;
}

}  // namespace

std::size_t chain_ik_bytes(const Skeleton& skeleton, const ChainGoal& goal) noexcept {
  return ik::chain_bytes(skeleton, goal);
}

ErrorCode check(const ChainIkJob& job) noexcept {
  if (job.skeleton == nullptr || !is_pose_of(job.local, job.skeleton->joint_count())) return ErrorCode::size_mismatch;
  if (!have_memory(job.goal.joints, job.goal.limits, job.goal.effectors)) return ErrorCode::size_mismatch;
  for (const JointLimit& limit : job.goal.limits)
    if (const ErrorCode code = check(limit); code != ErrorCode::ok) return code;
  ErrorCode code = check_joints(*job.skeleton, job.goal);
  if (code == ErrorCode::ok) code = check_numbers(job.goal);
  if (code != ErrorCode::ok) return code;
  const bool is_aligned = reinterpret_cast<std::uintptr_t>(job.memory.data()) % 64 == 0;
  return is_aligned && job.memory.size() >= chain_ik_bytes(*job.skeleton, job.goal) ? ErrorCode::ok
                                                                                    : ErrorCode::size_mismatch;
}

void run_unchecked(const ChainIkJob& job) noexcept {
  assert(check(job) == ErrorCode::ok && "run_unchecked takes only a job that check() accepts");
  const ChainGoal& goal = job.goal;
  if (job.result != nullptr) *job.result = {};
  if (goal.weight == 0.0f) return;
  ik::ChainTree tree = ik::make_chain_tree(job);
  std::uint32_t iterations = 0;
  double damping = 0.0;
  while (iterations < goal.iterations && !is_met(goal, tree.errors())) {
    if (iterations == 0) bend_straight_chains(tree);
    switch (goal.solver) {
      case ChainSolver::ccd: step_ccd(tree); break;
      case ChainSolver::fabrik: step_fabrik(tree); break;
      case ChainSolver::damped: iterations == 0 ? step_ccd(tree) : step_damped(tree, damping); break;
    }
    ++iterations;
  }
  bool can_reach = true;
  for (std::size_t i = 0; i < goal.effectors.size(); ++i) can_reach = can_reach && !is_beyond_reach(tree, i);
  if (iterations > 0) write(tree);
  if (job.result != nullptr) tell(tree, iterations, can_reach);
}

}  // namespace sinew
