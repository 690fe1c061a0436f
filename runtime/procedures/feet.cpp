// SPDX-License-Identifier: MIT
#include "runtime/procedures/feet.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "runtime/animation/truth_pose.h"
#include "runtime/math/axis_angle.h"
#include "runtime/math/decompose.h"
#include "runtime/math/inverse.h"
#include "runtime/math/rotation_between.h"
#include "runtime/procedures/joint_frames.h"
#include "runtime/procedures/two_bone_ik.h"

namespace sinew {
namespace {

using V = Vec3<double>;
using Q = Quat<double>;

const V kUp(0.0, 1.0, 0.0);
constexpr double kSameSlope = 0.4;      ///< difference of two slopes of the ground that may belong to one surface
constexpr double kFastestPelvis = 2.0;  ///< m/s that the goal of the pelvis moves; a faster change is a jump
constexpr double kSteepest = 3.0;       ///< rise of the ground over its run beyond which it counts as a jump

V horizontal(const V& v) noexcept { return {v.x, 0.0, v.z}; }

/// Critically damped motion of a value and its rate towards 0, exact for any step.
/// eq   x(t) = (x + (v + w x) t) e^(-w t),  (1 + w h) e^(-w h) = 1/2 for the half-life h
template <class T>
void fade(T& value, T& rate, double half_life_s, double dt_s) noexcept {
  constexpr double kHalf = 1.6783469900166605;
  if (half_life_s <= 0.0) {
    value = rate = T(0.0);
    return;
  }
  const double w = kHalf / half_life_s, left = std::exp(-w * dt_s);
  const T slope = rate + value * w;
  value = (value + slope * dt_s) * left;
  rate = (rate - slope * (w * dt_s)) * left;
}

/// A foot in the world, as the clip has it.
struct ClipFoot {
  V tip{0.0}, heel{0.0}, ankle{0.0}, hip{0.0};
  double lift = 0.0;  ///< of the tip above the clip's ground
};

/// A foot in the world, as it is to be shown.
struct FootGoal {
  V tip{0.0}, ankle{0.0};
  Q turn = quat_identity<double>();  ///< of the sole
};

class FeetRun {
 public:
  explicit FeetRun(const FeetJob& job) noexcept
      : job_(job), setup_(*job.setup), ground_y_(translation_of(job.root).y) {}

  void run() noexcept {
    const std::size_t count = setup_.feet.size();
    for (std::size_t i = 0; i < count; ++i) clip_[i] = clip_foot(setup_.feet[i]);
    for (std::size_t i = 0; i < count; ++i) goals_[i] = place(i);
    move_pelvis(pelvis_height());
    for (std::size_t i = 0; i < count; ++i) reach(i);
    job_.state->has_started = 1;
  }

 private:
  V world_place(std::uint32_t joint, const Vec3<float>& point) const noexcept {
    return transform_point(job_.root * model_matrix(*job_.skeleton, job_.local, joint), V(point));
  }

  ClipFoot clip_foot(const FootSetup& foot) const noexcept {
    ClipFoot out;
    out.tip = world_place(foot.toes == kNone ? foot.ankle : foot.toes, foot.tip);
    out.heel = world_place(foot.ankle, foot.heel);
    out.ankle = world_place(foot.ankle, Vec3<float>(0.0f));
    out.hip = world_place(foot.hip, Vec3<float>(0.0f));
    out.lift = out.tip.y - ground_y_;
    return out;
  }

  /// The tip on the flat ground that the clip plays on. A root that goes uphill makes no foot fast.
  static V above_root(const ClipFoot& clip) noexcept { return {clip.tip.x, clip.lift, clip.tip.z}; }

  FootGoal place(std::size_t i) noexcept {
    FeetState::Foot& foot = job_.state->feet[i];
    const ClipFoot& clip = clip_[i];
    if (!job_.state->has_started) foot = {.clip_tip = above_root(clip), .shown_tip = clip.tip};
    lock_or_free(foot, clip);
    FootGoal goal;
    const V at = foot.is_locked ? foot.shown_tip : horizontal(clip.tip) + horizontal(foot.offset);
    GroundHit hit{ground_y_, kUp};
    const bool has_ground = find(i, at, clip.tip.y, hit);
    follow_ground(foot, at, hit.height_m);
    foot.clip_tip = above_root(clip);
    goal.tip = {at.x, clip.tip.y + (hit.height_m - ground_y_) + foot.step, at.z};
    turn_with_ground(i, foot, hit, has_ground);
    const double held = 1.0 - smooth(clip.lift / (3.0 * std::max(setup_.contact_height_m, 1e-6)));
    goal.turn = part_of_turn(quat_identity<double>(), rotation_between(kUp, foot.normal), held);
    goal.ankle = goal.tip + rotate_vector(goal.turn, clip.ankle - clip.tip);
    return goal;
  }

  static double smooth(double t) noexcept {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
  }

  /// Decides whether the foot stays, and moves its offset.
  void lock_or_free(FeetState::Foot& foot, const ClipFoot& clip) const noexcept {
    const double dt = job_.dt_s;
    const V rate = dt > 0.0 ? (above_root(clip) - foot.clip_tip) / dt : V(0.0);
    const double speed = glm::length(rate);
    if (!foot.is_locked) fade(foot.offset, foot.offset_rate, setup_.half_life_s, dt);
    if (dt <= 0.0 && job_.state->has_started) return;
    if (foot.is_locked) {
      const double behind = glm::length(horizontal(clip.tip) - horizontal(foot.shown_tip));
      const bool goes_on = speed > setup_.free_above_m_s || behind > setup_.release_beyond_m ||
                           clip.lift > 2.0 * setup_.contact_height_m;
      if (!goes_on) return;
      foot.is_locked = 0;
      foot.offset = horizontal(foot.shown_tip) - horizontal(clip.tip);
      foot.offset_rate = -horizontal(rate);  // it stood still, so the offset changes as fast as the clip moves
    } else if (speed < setup_.lock_below_m_s && clip.lift < setup_.contact_height_m) {
      foot.is_locked = 1;
      const V at = horizontal(clip.tip) + horizontal(foot.offset);
      foot.shown_tip = {at.x, foot.shown_tip.y, at.z};
    }
  }

  bool find(std::size_t foot, const V& at, double from_y, GroundHit& hit) const noexcept {
    if (job_.ground.find == nullptr) return false;
    GroundHit found;
    if (!job_.ground.find(job_.ground.context, foot, {at.x, from_y, at.z}, found)) return false;
    const V unit = normalised_or(found.normal, kUp);
    if (!std::isfinite(found.height_m) || !std::isfinite(unit.x + unit.y + unit.z)) return false;
    hit = {found.height_m, unit};
    return true;
  }

  /// Where the ground is steeper than any slope, it jumps: what is shown goes on from where it was.
  void follow_ground(FeetState::Foot& foot, const V& at, double height) const noexcept {
    fade(foot.step, foot.step_rate, setup_.step_half_life_s, job_.dt_s);
    const double run = glm::length(at - horizontal(foot.shown_tip)), rise = height - foot.shown_tip.y;
    if (job_.state->has_started && std::abs(rise) > kSteepest * run + 1e-3) foot.step -= rise;
    foot.shown_tip = {at.x, height, at.z};
    if (!job_.state->has_started) foot.step = foot.step_rate = 0.0;
  }

  /// The normal of the ground between heel and tip, along the foot, and of the hit across it.
  void turn_with_ground(std::size_t i, FeetState::Foot& foot, const GroundHit& tip, bool has_ground) const noexcept {
    V wanted = kUp;
    if (has_ground) {
      wanted = tip.normal;
      const V along = horizontal(clip_[i].tip - clip_[i].heel);
      const V at = horizontal(foot.shown_tip) - along;
      GroundHit heel;
      const double run = glm::length(along);
      if (run > 1e-6 && find(i, at, clip_[i].heel.y, heel)) {
        const V forward = along / run, side = glm::cross(kUp, forward);
        const double flat = std::max(tip.normal.y, 1e-3);
        const double rise = (tip.height_m - heel.height_m) / run, rise_at_tip = -glm::dot(tip.normal, forward) / flat;
        // Between the treads of a stair lies no slope.
        if (std::abs(rise - rise_at_tip) < kSameSlope)
          wanted =
              normalised_or(glm::cross(forward + kUp * rise, side - kUp * (glm::dot(tip.normal, side) / flat)), kUp);
      }
    }
    const double angle = std::atan2(std::hypot(wanted.x, wanted.z), wanted.y);
    if (angle > setup_.most_slope_rad)
      wanted = rotate_vector(
          part_of_turn(quat_identity<double>(), rotation_between(kUp, wanted), setup_.most_slope_rad / angle), kUp);
    const double left =
        job_.state->has_started && setup_.half_life_s > 0.0 ? std::exp2(-job_.dt_s / (0.5 * setup_.half_life_s)) : 0.0;
    foot.normal = normalised_or(wanted + (foot.normal - wanted) * left, kUp);
  }

  /// Height by which the pelvis is to move: the highest at which no leg is straighter than in the clip.
  double pelvis_height() const noexcept {
    double height = setup_.most_pelvis_m;
    for (std::size_t i = 0; i < setup_.feet.size(); ++i) {
      const double reach = glm::length(clip_[i].ankle - clip_[i].hip);
      const double beside = glm::length(horizontal(goals_[i].ankle - clip_[i].hip));
      const double above = std::sqrt(std::max(0.0, reach * reach - beside * beside));
      height = std::min(height, goals_[i].ankle.y + above - clip_[i].hip.y);
    }
    return std::max(height, -setup_.most_pelvis_m);
  }

  void move_pelvis(double wanted) noexcept {
    FeetState& state = *job_.state;
    if (!state.has_started) {
      state.pelvis = state.pelvis_goal = wanted;
      state.pelvis_rate = 0.0;
    }
    // The offset from a goal that moves at its rate fades, so the pelvis does not lag behind a goal that goes uphill.
    const double dt = job_.dt_s;
    const double rate = dt > 0.0 ? std::clamp((wanted - state.pelvis_goal) / dt, -kFastestPelvis, kFastestPelvis) : 0.0;
    double left = state.pelvis - (wanted - rate * dt), left_rate = state.pelvis_rate - rate;
    fade(left, left_rate, setup_.pelvis_half_life_s, dt);
    state.pelvis = wanted + left;
    if (dt > 0.0) {
      state.pelvis_rate = rate + left_rate;
      state.pelvis_goal = wanted;
    }
    const std::uint32_t above = job_.skeleton->parents[setup_.pelvis];
    const auto back = inverse_of(job_.root * model_matrix(*job_.skeleton, job_.local, above));
    if (!back) return;
    const double share = static_cast<double>(job_.weight);
    Transform pelvis = job_.local.get(setup_.pelvis);
    pelvis.translation += glm::vec3(transform_vector(*back, kUp * (state.pelvis * share)));
    job_.local.set(setup_.pelvis, pelvis);
  }

  void reach(std::size_t i) noexcept {
    const FootSetup& foot = setup_.feet[i];
    FootGoal& goal = goals_[i];
    const V hip = clip_[i].hip + kUp * job_.state->pelvis;
    const double longest = glm::length(clip_[i].ankle - clip_[i].hip);
    const V leg = goal.ankle - hip;
    // In the air the leg comes no straighter than in the clip; near the ground the sole has precedence. A foot over the
    // edge of a step is in the air, too.
    const double excess = std::max(0.0, glm::length(leg) - longest), low = std::max(setup_.contact_height_m, 1e-6);
    const double air = std::max(smooth(clip_[i].lift / low - 1.0), smooth(std::abs(job_.state->feet[i].step) / low));
    goal.ankle -= normalised_or(leg, V(0.0)) * (excess * air);
    const std::optional<Affined> back = inverse_of(job_.root);
    FootResult result;
    result.is_locked = job_.state->feet[i].is_locked != 0;
    if (back) {
      const Q root = decompose_trs(job_.root).transform.rotation;
      const Q ankle = model_rotation(*job_.skeleton, job_.local, foot.ankle);
      TwoBoneIkJob ik{
          .skeleton = job_.skeleton, .local = job_.local, .goal = {}, .above = nullptr, .result = &result.ik};
      ik.goal.root = foot.hip;
      ik.goal.middle = foot.knee;
      ik.goal.tip = foot.ankle;
      ik.goal.target = transform_point(*back, goal.ankle);
      ik.goal.end = EndRotation::given;
      ik.goal.end_rotation = quat_cast<float>(normalised(quat_conjugate(root) * goal.turn * root * ankle));
      ik.goal.weight = job_.weight;
      sinew::run_unchecked(ik);
    }
    if (i >= job_.results.size()) return;
    const auto above_ground = [&](const V& place) {
      GroundHit hit{ground_y_, kUp};
      find(i, horizontal(place), place.y, hit);
      return static_cast<float>(place.y - hit.height_m);
    };
    result.tip_above_ground_m = above_ground(world_place(foot.toes == kNone ? foot.ankle : foot.toes, foot.tip));
    result.heel_above_ground_m = above_ground(world_place(foot.ankle, foot.heel));
    job_.results[i] = result;
  }

  const FeetJob& job_;
  const FeetSetup& setup_;
  const double ground_y_;
  std::array<ClipFoot, kMostFeet> clip_;
  std::array<FootGoal, kMostFeet> goals_;
};

bool can_move(const Skeleton& skeleton, const FootSetup& foot) noexcept {
  return is_below(skeleton, foot.knee, foot.hip) && is_below(skeleton, foot.ankle, foot.knee) &&
         foot.hip != foot.knee && foot.knee != foot.ankle &&
         (foot.toes == kNone || is_below(skeleton, foot.toes, foot.ankle)) && can_turn(skeleton, foot.hip) &&
         can_turn(skeleton, foot.knee) && can_turn(skeleton, foot.ankle);
}

}  // namespace

FootSetup foot_on_rest_ground(const Skeleton& skeleton, std::uint32_t hip, std::uint32_t knee, std::uint32_t ankle,
                              std::uint32_t toes) {
  std::vector<Transformd> rest;
  for (const Transform& t : skeleton.rest) rest.push_back(in_double(t));
  std::vector<Affined> model(rest.size());
  model_from_local(skeleton, rest, model);
  const auto below = [&](std::uint32_t joint) {
    V place = translation_of(model[joint]);
    place.y = 0.0;
    return glm::vec3(transform_point(inverse_of(model[joint]).value_or(Affined{}), place));
  };
  return {hip, knee, ankle, toes, below(ankle), below(toes == kNone ? ankle : toes)};
}

ErrorCode check(const FeetJob& job) noexcept {
  if (job.skeleton == nullptr || job.setup == nullptr || job.state == nullptr) return ErrorCode::size_mismatch;
  const Skeleton& skeleton = *job.skeleton;
  const FeetSetup& setup = *job.setup;
  const std::size_t joints = skeleton.joint_count();
  if (!is_pose_of(job.local, joints) || setup.feet.size() > kMostFeet ||
      (!job.results.empty() && job.results.size() < setup.feet.size()))
    return ErrorCode::size_mismatch;
  const double settings[] = {
      setup.lock_below_m_s,     setup.free_above_m_s, setup.contact_height_m, setup.release_beyond_m, setup.half_life_s,
      setup.pelvis_half_life_s, setup.most_pelvis_m,  setup.step_half_life_s, setup.most_slope_rad,   job.dt_s};
  for (const double number : settings) {
    if (!std::isfinite(number)) return ErrorCode::not_finite;
    if (number < 0.0) return ErrorCode::not_a_fraction;
  }
  if (!(job.weight >= 0.0f && job.weight <= 1.0f)) return ErrorCode::not_a_fraction;
  for (const auto& row : job.root.row)
    if (!std::isfinite(row.x + row.y + row.z + row.w)) return ErrorCode::not_finite;
  if (setup.pelvis >= joints) return ErrorCode::index_out_of_range;
  if (!can_turn(skeleton, setup.pelvis)) return ErrorCode::unsupported;
  for (const FootSetup& foot : setup.feet) {
    if (std::max({foot.hip, foot.knee, foot.ankle}) >= joints || (foot.toes != kNone && foot.toes >= joints))
      return ErrorCode::index_out_of_range;
    const V points = V(foot.heel) + V(foot.tip);
    if (!std::isfinite(points.x + points.y + points.z)) return ErrorCode::not_finite;
    if (!can_move(skeleton, foot) || !is_below(skeleton, foot.hip, setup.pelvis)) return ErrorCode::unsupported;
  }
  return ErrorCode::ok;
}

void run_unchecked(const FeetJob& job) noexcept {
  assert(check(job) == ErrorCode::ok && "run_unchecked takes only a job that check() accepts");
  if (job.weight == 0.0f) {
    *job.state = {};
    return;
  }
  FeetRun(job).run();
}

PoseProcedure as_procedure(Feet& feet) noexcept {
  const auto run_feet = [](void* context, const ProcedurePose& pose) {
    Feet& own = *static_cast<Feet*>(context);
    const FeetJob job{.skeleton = &pose.skeleton,
                      .local = pose.local,
                      .setup = &own.setup,
                      .root = own.root,
                      .dt_s = own.dt_s,
                      .ground = own.ground,
                      .state = &own.state,
                      .weight = pose.share,
                      .results = own.results};
    own.error = run(job);
  };
  return {run_feet, &feet, 0};
}

}  // namespace sinew
