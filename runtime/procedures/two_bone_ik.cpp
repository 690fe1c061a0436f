// SPDX-License-Identifier: MIT
#include "runtime/procedures/two_bone_ik.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>

#include "runtime/base/all_finite.h"
#include "runtime/math/interpolate.h"
#include "runtime/math/inverse.h"
#include "runtime/procedures/hinge.h"
#include "runtime/procedures/joint_frames.h"
#include "runtime/procedures/limb_lanes.h"

namespace sinew {
namespace {

using V = Vec3<double>;
using Q = Quat<double>;
using M = Mat3<double>;

/// A limb in the space of the root joint's parent, with the root joint as origin.
struct Limb {
  Affined above;                ///< matrix from the space of the parent to model space
  std::optional<Affined> back;  ///< its inverse; none if it is singular
  V place;                      ///< place of the root joint, in the space of the parent
  Q root, middle;               ///< rotations in the pose
  ik::Bones bones;
  V tip;  ///< from the root joint to the tip, in the space of the parent
};

M scale_matrix(const V& scale) noexcept { return {scale.x, 0, 0, 0, scale.y, 0, 0, 0, scale.z}; }

/// The bones of the rest pose. They give the bend plane if the pose is straight.
ik::Bones rest_bones(const Skeleton& skeleton, const TwoBoneGoal& goal) noexcept {
  const auto local = [&](std::uint32_t j) {
    const std::uint32_t fixed = skeleton.fixed_matrix_of[j];
    if (fixed != kNone) return affine_cast<double>(skeleton.fixed_matrices[fixed]);
    const Transform& t = skeleton.rest[j];
    return affine_from_transform(Transformd{V(t.translation), quat_cast<double>(t.rotation), V(t.scale)});
  };
  Affined between, below;
  for (std::uint32_t j = skeleton.parents[goal.middle]; j != goal.root; j = skeleton.parents[j])
    between = local(j) * between;
  for (std::uint32_t j = goal.tip; j != goal.middle; j = skeleton.parents[j]) below = local(j) * below;
  const M to_root = scale_matrix(V(skeleton.rest[goal.root].scale)) * linear_part(between);
  const Affined middle = local(goal.middle);
  return ik::bones_of(
      to_root, scale_matrix(V(skeleton.rest[goal.root].scale)) * transform_point(between, translation_of(middle)),
      transform_vector(middle, translation_of(below)));
}

Limb read_limb(const TwoBoneIkJob& job) noexcept {
  const Skeleton& skeleton = *job.skeleton;
  const TwoBoneGoal& goal = job.goal;
  const auto parent = [&](std::uint32_t j) { return skeleton.parents[j]; };
  const Transformd root = local_of(job.local, goal.root), middle = local_of(job.local, goal.middle);
  Limb limb;
  limb.above = job.above != nullptr ? *job.above : model_matrix(skeleton, job.local, parent(goal.root));
  limb.back = inverse_of(limb.above);
  limb.place = root.translation;
  limb.root = normalised(root.rotation);
  limb.middle = normalised(middle.rotation);
  const Affined between = matrix_below(skeleton, job.local, goal.root, parent(goal.middle));
  const V below = parent(goal.tip) == goal.middle
                      ? local_of(job.local, goal.tip).translation
                      : translation_of(matrix_below(skeleton, job.local, goal.middle, goal.tip));
  const bool is_next = parent(goal.middle) == goal.root;
  const M to_root = is_next ? scale_matrix(root.scale) : scale_matrix(root.scale) * linear_part(between);
  limb.bones = ik::bones_of(to_root, root.scale * transform_point(between, middle.translation),
                            rotate_vector(limb.middle, middle.scale * below));
  limb.tip = rotate_vector(limb.root, limb.bones.upper + limb.bones.to_root * limb.bones.lower);
  return limb;
}

/// Direction of the pole in the space of the parent; zero without a pole. Any matrix maps planes through the line to
/// the target to such planes, so scale does not matter.
V pole_of(const Limb& limb, const TwoBoneIkJob& job) noexcept {
  const TwoBoneGoal& goal = job.goal;
  switch (goal.pole_kind) {
    case PoleKind::none: return V(0.0);
    case PoleKind::direction: return transform_vector(*limb.back, goal.pole);
    case PoleKind::point: return transform_point(*limb.back, goal.pole) - limb.place;
    case PoleKind::tip_axis:
      if (goal.end == EndRotation::given)
        return transform_vector(*limb.back, rotate_vector(quat_cast<double>(goal.end_rotation), goal.pole));
      return transform_vector(matrix_below(*job.skeleton, job.local, job.skeleton->parents[goal.root], goal.tip),
                              goal.pole);
  }
  return V(0.0);
}

/// in   lower  from the middle joint to the tip, in the space of the middle joint's parent
ik::Frame frame_of(const ik::Bones& bones, const ik::Hinge& hinge, const V& lower) noexcept {
  // A folded limb has its tip at the root, which gives no direction. It opens towards axis x upper, with the middle
  // joint on the side.
  constexpr double kFolded = 1e-4;
  const V tip = bones.upper_here + lower;
  const double reach = safe_length(tip);
  V here = tip / reach;
  if (!(reach > kFolded * bones.length_here)) {
    const V open = normalised_or(glm::cross(hinge.axis, bones.upper_here), V(1, 0, 0));
    here = two_bones::blended_side(tip / bones.length_here, open, kFolded);
  }
  const V along = normalised_or(bones.to_root * here, V(1, 0, 0));
  const V side = bones.to_root * glm::cross(here, hinge.axis), across = side - along * glm::dot(side, along);
  const double length = safe_length(across);
  return {along, length > 0.0 ? across / length : perpendicular_to(along)};
}

/// Rotations of a solved limb, and the factor by which its bones are lengthened.
struct Solved {
  Q root, middle;
  double stretch = 1.0;
  bool can_reach = true;
};

Solved solve(const Limb& limb, const TwoBoneIkJob& job, const V& target, double pole_share) noexcept {
  const TwoBoneGoal& goal = job.goal;
  const ik::Bones& bones = limb.bones;
  const V pole = pole_of(limb, job);
  const auto rest_axis = [&] { return ik::bend_axis(rest_bones(*job.skeleton, goal)); };
  const V pole_at_root = rotate_vector(quat_conjugate(limb.root), pole);
  const ik::Hinge hinge = ik::hinge_of(bones, rotate_vector(limb.middle, V(goal.middle_axis)), pole_at_root, rest_axis);
  const ik::Reach reach =
      ik::reach_of(bones, hinge, static_cast<double>(goal.least_bend_rad), static_cast<double>(goal.most_bend_rad));
  const double wanted = safe_length(target), soft = static_cast<double>(goal.soft_reach);
  const double near = std::max(two_bones::soft_stop(wanted, (1.0 - soft) * reach.most, reach.most), reach.least);
  Solved solved;
  solved.can_reach = wanted <= reach.most * (1.0 + 1e-9) && wanted >= reach.least * (1.0 - 1e-9);
  if (wanted > near && near > 0.0) solved.stretch = std::min(wanted / near, static_cast<double>(goal.most_stretch));
  const Q bend = ik::bend_to(bones, hinge, reach, near);
  solved.middle = normalised(bend * limb.middle);

  const ik::Frame before = frame_of(bones, hinge, bones.lower),
                  after = frame_of(bones, hinge, rotate_vector(bend, bones.lower));
  const ik::Frame now{rotate_vector(limb.root, before.along), rotate_vector(limb.root, before.side)};
  const ik::Frame wish = ik::aimed_frame(
      now, target, {pole, static_cast<double>(goal.pole_fade), pole_share, static_cast<double>(goal.twist_rad)});
  solved.root = quat_from_matrix(wish.matrix() * glm::transpose(after.matrix()));
  return solved;
}

/// Vector from the root joint to the tip, from the rotations that were written to the pose as float. Stretch is not
/// included.
V written_tip(const Limb& limb, const TwoBoneIkJob& job) noexcept {
  const auto rotation = [&](std::uint32_t j) { return normalised(quat_cast<double>(job.local.get(j).rotation)); };
  const V lower = rotate_vector(rotation(job.goal.middle) * quat_conjugate(limb.middle), limb.bones.lower);
  return rotate_vector(rotation(job.goal.root), limb.bones.upper + limb.bones.to_root * lower);
}

/// Length of the straight limb in model space.
double length_of(const Limb& limb) noexcept {
  const auto length = [&](const V& bone) {
    return safe_length(transform_vector(limb.above, rotate_vector(limb.root, bone)));
  };
  return length(limb.bones.upper) + length(limb.bones.to_root * limb.bones.lower);
}

void stretch_bones(const TwoBoneIkJob& job, double factor) noexcept {
  for (std::uint32_t j = job.goal.tip; j != job.goal.root; j = job.skeleton->parents[j])
    for (const PoseSpan::Plane plane : {PoseSpan::tx, PoseSpan::ty, PoseSpan::tz}) {
      float& number = job.local.plane(plane)[j];
      number = static_cast<float>(static_cast<double>(number) * factor);
    }
}

/// Rotates the tip as the goal asks, after the bones above it were turned.
/// in   before  model rotation of the tip in the input pose
void turn_tip(const TwoBoneIkJob& job, const Q& before, double weight) noexcept {
  const TwoBoneGoal& goal = job.goal;
  Q wanted = before;
  if (goal.end == EndRotation::given) wanted = part_of_turn(before, quat_cast<double>(goal.end_rotation), weight);
  const Q above = model_rotation(*job.skeleton, job.local, job.skeleton->parents[goal.tip]);
  write_rotation(job.local, goal.tip, quat_conjugate(above) * wanted);
}

bool in_line(const Skeleton& skeleton, const TwoBoneGoal& goal) noexcept {
  return goal.root < goal.middle && goal.middle < goal.tip && is_below(skeleton, goal.tip, goal.middle) &&
         is_below(skeleton, goal.middle, goal.root);
}

bool all_can_turn(const Skeleton& skeleton, const TwoBoneGoal& goal) noexcept {
  bool can = can_turn(skeleton, goal.root);
  for (std::uint32_t j = goal.tip; j != goal.root; j = skeleton.parents[j])
    can = can && (can_turn(skeleton, j) || (goal.most_stretch == 1.0f && j != goal.middle && j != goal.tip));
  return can;
}

ErrorCode check_numbers(const TwoBoneGoal& goal) noexcept {
  const double doubles[] = {goal.target.x, goal.target.y, goal.target.z, goal.pole.x, goal.pole.y, goal.pole.z};
  const float floats[] = {goal.end_rotation.x, goal.end_rotation.y, goal.end_rotation.z, goal.end_rotation.w,
                          goal.middle_axis.x,  goal.middle_axis.y,  goal.middle_axis.z,  goal.twist_rad,
                          goal.weight,         goal.soft_reach,     goal.most_stretch,   goal.least_bend_rad,
                          goal.most_bend_rad,  goal.pole_fade,      goal.tolerance};
  if (!all_finite(std::span<const double>(doubles)) || !all_finite(std::span<const float>(floats)))
    return ErrorCode::not_finite;
  const auto is_share = [](float x) { return x >= 0.0f && x < 1.0f; };
  if (!(goal.weight >= 0.0f && goal.weight <= 1.0f) || !is_share(goal.soft_reach) || !is_share(goal.pole_fade))
    return ErrorCode::not_a_fraction;
  if (goal.tolerance < 0.0f) return ErrorCode::negative_weight;
  const bool bends = goal.least_bend_rad >= 0.0f && goal.least_bend_rad <= goal.most_bend_rad &&
                     static_cast<double>(goal.most_bend_rad) <= std::numbers::pi + 1e-6;
  return bends && goal.most_stretch >= 1.0f ? ErrorCode::ok : ErrorCode::too_large;
}

}  // namespace

ErrorCode check(const TwoBoneIkJob& job) noexcept {
  if (job.skeleton == nullptr || !is_pose_of(job.local, job.skeleton->joint_count())) return ErrorCode::size_mismatch;
  const TwoBoneGoal& goal = job.goal;
  if (std::max({goal.root, goal.middle, goal.tip}) >= job.skeleton->joint_count()) return ErrorCode::index_out_of_range;
  if (!in_line(*job.skeleton, goal) || !all_can_turn(*job.skeleton, goal)) return ErrorCode::unsupported;
  return check_numbers(goal);
}

void run_unchecked(const TwoBoneIkJob& job) noexcept {
  assert(check(job) == ErrorCode::ok && "run_unchecked takes only a job that check() accepts");
  ik::run_limbs({&job, 1});
}

ErrorCode check(const TwoBoneIkLimbsJob& job) noexcept {
  if (!have_memory(job.limbs)) return ErrorCode::size_mismatch;
  for (const TwoBoneIkJob& limb : job.limbs)
    if (const ErrorCode code = check(limb); code != ErrorCode::ok) return code;
  return ErrorCode::ok;
}

void run_unchecked(const TwoBoneIkLimbsJob& job) noexcept {
  assert(check(job) == ErrorCode::ok && "run_unchecked takes only a job that check() accepts");
  ik::run_limbs(job.limbs);
}

Q ik::tip_before(const TwoBoneIkJob& job) noexcept {
  if (job.goal.end == EndRotation::follow) return quat_identity<double>();
  return model_rotation(*job.skeleton, job.local, job.goal.tip);
}

void ik::finish_limb(const TwoBoneIkJob& job, const Q& tip) noexcept {
  if (job.goal.end != EndRotation::follow) turn_tip(job, tip, static_cast<double>(job.goal.weight));
}

void ik::report(const TwoBoneIkJob& job, double metres, double length, bool can_reach) noexcept {
  IkResult& result = *job.result;
  result = {};
  result.metres_left = static_cast<float>(metres);
  if (job.goal.end == EndRotation::given)
    result.radians_left = static_cast<float>(rotation_angle_between(
        model_rotation(*job.skeleton, job.local, job.goal.tip), quat_cast<double>(job.goal.end_rotation)));
  const double allowed = static_cast<double>(job.goal.tolerance) * length;
  result.status = metres <= allowed ? IkStatus::reached : can_reach ? IkStatus::limited : IkStatus::unreachable;
}

void ik::solve_general(const TwoBoneIkJob& job) noexcept {
  const TwoBoneGoal& goal = job.goal;
  const double weight = static_cast<double>(goal.weight);
  const Limb limb = read_limb(job);
  const Q tip = tip_before(job);
  V left = transform_point(limb.above, limb.place + limb.tip) - goal.target;
  bool can_reach = false;
  if (limb.back) {  // a singular parent matrix lets no joint reach anything, so the pose stays
    const V target = transform_point(*limb.back, goal.target) - limb.place;
    const bool by_effector = goal.blend == IkBlend::effector;
    const Solved solved =
        solve(limb, job, by_effector ? lerp(limb.tip, target, weight) : target, by_effector ? weight : 1.0);
    const double share = by_effector ? 1.0 : weight;
    const double stretch = lerp(1.0, solved.stretch, share);
    write_rotation(job.local, goal.root, part_of_turn(limb.root, solved.root, share));
    write_rotation(job.local, goal.middle, part_of_turn(limb.middle, solved.middle, share));
    if (stretch != 1.0) stretch_bones(job, stretch);
    if (job.result != nullptr) left = transform_vector(limb.above, written_tip(limb, job) * stretch - target);
    can_reach = solved.can_reach || solved.stretch > 1.0;
  }
  finish_limb(job, tip);
  if (job.result != nullptr) report(job, safe_length(left), length_of(limb), can_reach);
}

}  // namespace sinew
