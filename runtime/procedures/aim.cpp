// SPDX-License-Identifier: MIT
#include "runtime/procedures/aim.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "runtime/base/all_finite.h"
#include "runtime/math/inverse.h"
#include "runtime/procedures/joint_frames.h"

namespace sinew {
namespace {

using V = Vec3<double>;
using Q = Quat<double>;

/// The line that aims.
struct Line {
  V begin, forward, up;
};

Line moved(const Affined& matrix, const Line& line) noexcept {
  return {transform_point(matrix, line.begin), transform_vector(matrix, line.forward),
          transform_vector(matrix, line.up)};
}

Line scaled(const V& scale, const Line& line) noexcept {
  return {scale * line.begin, scale * line.forward, scale * line.up};
}

Line line_of(const AimGoal& goal) noexcept { return {V(goal.offset), V(goal.forward), V(goal.up)}; }

/// Frame of a line. Its x axis points from the joint to the point of the line at this distance.
/// out  hits  false if the line has no point at this distance
ik::Frame frame_of(const Line& line, double distance, bool& hits) noexcept {
  const V forward = normalised_or(line.forward, V(0, 0, 1));
  const double along = glm::dot(line.begin, forward);
  const double square = along * along - glm::dot(line.begin, line.begin) + distance * distance;
  const double way = std::sqrt(std::max(0.0, square)) - along;
  hits = square >= 0.0 && way >= 0.0 && distance > 0.0;
  ik::Frame frame;
  frame.along = normalised_or(line.begin + forward * std::max(0.0, way), forward);
  frame.side = ik::unit_beside(line.up, frame.along, perpendicular_to(frame.along));
  return frame;
}

/// The rotation of one joint that makes the line aim at the target.
/// out  can_reach  false if no rotation of this joint does
Q aimed(const AimJob& job, std::uint32_t joint, const Q& now, bool& can_reach) noexcept {
  const AimGoal& goal = job.goal;
  const std::uint32_t last = goal.joints.back().joint;
  can_reach = false;
  const auto back = inverse_of(model_matrix(*job.skeleton, job.local, job.skeleton->parents[joint]));
  if (!back) return now;
  const Transformd local = local_of(job.local, joint);
  const Line line = scaled(local.scale, moved(matrix_below(*job.skeleton, job.local, joint, last), line_of(goal)));
  const V target = transform_point(*back, goal.target) - local.translation;
  const ik::Frame of_joint = frame_of(line, safe_length(target), can_reach);
  const ik::Frame here{rotate_vector(now, of_joint.along), rotate_vector(now, of_joint.side)};
  const ik::Roll roll{transform_vector(*back, goal.pole), static_cast<double>(goal.pole_fade), 1.0,
                      static_cast<double>(goal.twist_rad)};
  const ik::Frame wish = ik::aimed_frame(here, target, roll);
  return quat_from_matrix(wish.matrix() * glm::transpose(of_joint.matrix()));
}

void tell(const AimJob& job, bool can_reach) noexcept {
  const AimGoal& goal = job.goal;
  const Line line = moved(model_matrix(*job.skeleton, job.local, goal.joints.back().joint), line_of(goal));
  const V way = goal.target - line.begin, forward = normalised_or(line.forward, V(0.0));
  const double beside = safe_length(glm::cross(forward, way)), before = glm::dot(forward, way);
  const double angle = std::atan2(beside, before);
  job.result->radians_left = static_cast<float>(angle);
  job.result->metres_left = static_cast<float>(before > 0.0 ? beside : safe_length(way));
  job.result->status = angle <= static_cast<double>(goal.tolerance_rad) ? IkStatus::reached
                       : can_reach                                      ? IkStatus::limited
                                                                        : IkStatus::unreachable;
}

ErrorCode check_joints(const Skeleton& skeleton, const AimGoal& goal) noexcept {
  if (goal.joints.empty()) return ErrorCode::unsupported;
  std::uint32_t above = kNone;
  for (const AimJoint& joint : goal.joints) {
    if (joint.joint >= skeleton.joint_count()) return ErrorCode::index_out_of_range;
    if (joint.limit != kNone && joint.limit >= goal.limits.size()) return ErrorCode::index_out_of_range;
    if (!can_turn(skeleton, joint.joint)) return ErrorCode::unsupported;
    if (above != kNone && (joint.joint <= above || !is_below(skeleton, joint.joint, above)))
      return ErrorCode::unsupported;
    if (!std::isfinite(joint.share)) return ErrorCode::not_finite;
    if (joint.share < 0.0f) return ErrorCode::negative_weight;
    above = joint.joint;
  }
  return ErrorCode::ok;
}

ErrorCode check_numbers(const AimGoal& goal) noexcept {
  const double doubles[] = {goal.target.x, goal.target.y, goal.target.z, goal.pole.x, goal.pole.y, goal.pole.z};
  const float floats[] = {goal.forward.x, goal.forward.y, goal.forward.z,    goal.up.x,     goal.up.y,
                          goal.up.z,      goal.offset.x,  goal.offset.y,     goal.offset.z, goal.weight,
                          goal.twist_rad, goal.pole_fade, goal.tolerance_rad};
  if (!all_finite(std::span<const double>(doubles)) || !all_finite(std::span<const float>(floats)))
    return ErrorCode::not_finite;
  const bool is_share = goal.weight >= 0.0f && goal.weight <= 1.0f;
  if (!is_share || !(goal.pole_fade >= 0.0f && goal.pole_fade < 1.0f)) return ErrorCode::not_a_fraction;
  if (goal.tolerance_rad < 0.0f) return ErrorCode::negative_weight;
  const V forward = normalised_or(V(goal.forward), V(0.0)), up = normalised_or(V(goal.up), V(0.0));
  return safe_length(glm::cross(forward, up)) > 1e-6 ? ErrorCode::ok : ErrorCode::unsupported;
}

}  // namespace

ErrorCode check(const AimJob& job) noexcept {
  if (job.skeleton == nullptr || !is_pose_of(job.local, job.skeleton->joint_count())) return ErrorCode::size_mismatch;
  if (!have_memory(job.goal.joints, job.goal.limits)) return ErrorCode::size_mismatch;
  for (const JointLimit& limit : job.goal.limits)
    if (const ErrorCode code = check(limit); code != ErrorCode::ok) return code;
  const ErrorCode code = check_joints(*job.skeleton, job.goal);
  return code != ErrorCode::ok ? code : check_numbers(job.goal);
}

void run_unchecked(const AimJob& job) noexcept {
  assert(check(job) == ErrorCode::ok && "run_unchecked takes only a job that check() accepts");
  const AimGoal& goal = job.goal;
  if (job.result != nullptr) *job.result = {};
  if (goal.weight == 0.0f) return;
  double whole = 0.0;
  for (const AimJoint& joint : goal.joints) whole += static_cast<double>(joint.share);
  double rest = 1.0;  // share of the turn that is left before this joint
  bool can_reach = false;
  for (const AimJoint& joint : goal.joints) {
    const Q now = normalised(quat_cast<double>(job.local.get(joint.joint).rotation));
    const Q wanted = aimed(job, joint.joint, now, can_reach);
    const double own = whole > 0.0 ? static_cast<double>(goal.weight) * static_cast<double>(joint.share) / whole : 0.0;
    const double share = rest > own ? own / rest : 1.0;
    rest -= own;
    if (own == 0.0) continue;
    Q turned = part_of_turn(now, wanted, share);
    if (joint.limit != kNone) turned = JointLimiter(goal.limits[joint.limit])(turned).rotation;
    write_rotation(job.local, joint.joint, turned);
  }
  if (job.result != nullptr) tell(job, can_reach);
}

}  // namespace sinew
