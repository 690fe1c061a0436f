// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "runtime/procedures/joint_frames.h"
#include "runtime/procedures/limb_lanes.h"

namespace sinew::ik {
namespace {

void set_rotation(LimbRotations& rotations, std::size_t i, const glm::quat& q) noexcept {
  const Quat<double> wide = quat_cast<double>(q);
  rotations.x[i] = wide.x;
  rotations.y[i] = wide.y;
  rotations.z[i] = wide.z;
  rotations.w[i] = wide.w;
}

glm::quat rotation_in(const LimbRotations& rotations, std::size_t i) noexcept {
  return quat_cast<float>(quat_xyzw(rotations.x[i], rotations.y[i], rotations.z[i], rotations.w[i]));
}

/// Cosine of a bend. Straight and folded are exact, so they add no rounding to the reach.
double bend_cosine(float bend_rad) noexcept {
  const double bend = static_cast<double>(bend_rad);
  if (bend == 0.0) return 1.0;
  return bend >= std::numbers::pi - 1e-6 ? -1.0 : std::cos(bend);
}

/// Direction of the pole in model space; zero without a pole.
Vec3<double> model_pole(const TwoBoneIkJob& job, const Affined& above, const Vec3<double>& place) noexcept {
  const TwoBoneGoal& goal = job.goal;
  switch (goal.pole_kind) {
    case PoleKind::none: return Vec3<double>(0.0);
    case PoleKind::direction: return goal.pole;
    case PoleKind::point: return goal.pole - transform_point(above, place);
    case PoleKind::tip_axis:
      if (goal.end == EndRotation::given) return rotate_vector(quat_cast<double>(goal.end_rotation), goal.pole);
      return transform_vector(
          above, transform_vector(matrix_below(*job.skeleton, job.local, job.skeleton->parents[goal.root], goal.tip),
                                  goal.pole));
  }
  return Vec3<double>(0.0);
}

bool is_plain(const TwoBoneIkJob& job) noexcept {
  const TwoBoneGoal& goal = job.goal;
  const Vec3<float> scale = job.local.get(goal.root).scale;
  return goal.weight == 1.0f && goal.twist_rad == 0.0f && job.skeleton->parents[goal.middle] == goal.root &&
         job.skeleton->parents[goal.tip] == goal.middle && scale.x > 0.0f && scale.x == scale.y && scale.x == scale.z;
}

}  // namespace

void read_plain(const TwoBoneIkJob& job, PlainLimbs& limbs, std::size_t i) noexcept {
  const TwoBoneGoal& goal = job.goal;
  const Transform root = job.local.get(goal.root), middle = job.local.get(goal.middle);
  const Vec3<double> place(root.translation), tip(job.local.get(goal.tip).translation);
  const double scale = static_cast<double>(root.scale.x), fade = static_cast<double>(goal.pole_fade);
  const Affined above =
      job.above != nullptr ? *job.above : model_matrix(*job.skeleton, job.local, job.skeleton->parents[goal.root]);
  for (int c = 0; c < 3; ++c) limbs.above[c].set(i, {above.row[0][c], above.row[1][c], above.row[2][c]});
  limbs.target.set(i, goal.target - translation_of(above));
  limbs.pole.set(i, model_pole(job, above, place));
  limbs.axis.set(i, Vec3<double>(goal.middle_axis));
  limbs.place.set(i, place);
  limbs.upper.set(i, Vec3<double>(middle.translation) * scale);
  limbs.lower.set(i, Vec3<double>(middle.scale) * tip * scale);
  set_rotation(limbs.root, i, root.rotation);
  set_rotation(limbs.middle, i, middle.rotation);
  limbs.pole_fade[i] = fade;
  limbs.per_fade[i] = fade > 0.0 ? 1.0 / fade : 0.0;
  limbs.least_cosine[i] = bend_cosine(goal.least_bend_rad);
  limbs.most_cosine[i] = bend_cosine(goal.most_bend_rad);
  const bool is_rigid = goal.soft_reach == 0.0f && goal.most_stretch == 1.0f;
  limbs.free_share[i] = is_rigid ? std::numeric_limits<double>::infinity() : 1.0 - static_cast<double>(goal.soft_reach);
}

namespace {

/// Up to kLimbLanes limbs, solved together.
void run_block(std::span<const TwoBoneIkJob> jobs) noexcept {
  PlainLimbs limbs;
  SolvedLimbs solved;
  const TwoBoneIkJob* lane[kLimbLanes];
  std::size_t count = 0;
  bool measures = false;
  for (const TwoBoneIkJob& job : jobs) {
    if (job.goal.weight == 0.0f) {
      if (job.result != nullptr) *job.result = {};
    } else if (is_plain(job)) {
      measures = measures || job.result != nullptr;
      read_plain(job, limbs, count);
      lane[count++] = &job;
    } else {
      solve_general(job);
    }
  }
  if (count == 0) return;
  for (std::size_t i = count; count > 1 && i < kLimbLanes; ++i) read_plain(*lane[0], limbs, i);
  solve_limbs(limbs, count, measures, solved);
  for (std::size_t i = 0; i < count; ++i) {
    const TwoBoneIkJob& job = *lane[i];
    if (solved.is_solved[i] == 0.0) {
      solve_general(job);
      continue;
    }
    const Quat<double> tip = tip_before(job);
    job.local.set_rotation(job.goal.root, rotation_in(solved.root, i));
    job.local.set_rotation(job.goal.middle, rotation_in(solved.middle, i));
    finish_limb(job, tip);
    if (job.result != nullptr) report(job, solved.metres_left[i], solved.length[i], solved.can_reach[i] != 0.0);
  }
}

}  // namespace

void run_limbs(std::span<const TwoBoneIkJob> jobs) noexcept {
  for (std::size_t first = 0; first < jobs.size(); first += kLimbLanes)
    run_block(jobs.subspan(first, std::min(kLimbLanes, jobs.size() - first)));
}

}  // namespace sinew::ik
