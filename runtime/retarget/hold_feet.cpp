// SPDX-License-Identifier: MIT
#include "runtime/retarget/hold_feet.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <vector>

#include "runtime/animation/truth_pose.h"
#include "runtime/math/two_bones.h"
#include "runtime/retarget/dense_times.h"
#include "runtime/retarget/foot_contact.h"
#include "runtime/retarget/leg_pose.h"

namespace sinew {
namespace {

/// The two poses that a foot is held between: how their joints are read, and how those of the target are written.
template <class SourceLocal, class TargetLocal, class Set>
struct FootPoses {
  SourceLocal source;  ///< (joint) -> TransformT<T>
  TargetLocal target;
  Set set_rotation;  ///< (joint, rotation), of the target
};
template <class SourceLocal, class TargetLocal, class Set>  // clang deduces these of aggregates from version 17 on
FootPoses(SourceLocal, TargetLocal, Set)->FootPoses<SourceLocal, TargetLocal, Set>;

/// A leg of the target before it is held, and where its ankle goes.
template <class T>
struct LegGoal {
  LegPose<T> pose;
  Vec3<T> ankle;
  T held = T(0);
};

template <class T, class Poses>
LegGoal<T> leg_goal(const LegPair& leg, T ratio, T ground, const Poses& poses) {
  const FootContact<T> contact = foot_contact(leg, leg_pose<T>(leg.source, poses.source), ground);
  LegGoal<T> goal{leg_pose<T>(leg.target, poses.target), Vec3<T>(T(0)), contact.held};
  goal.ankle = goal.pose.foot.place;
  if (goal.held > T(0)) goal.ankle += (foot_goal(leg, contact, ratio, goal.pose) - goal.ankle) * goal.held;
  return goal;
}

/// How far the hips come down so that the leg reaches its goal, at most a fourth of its length. 0 below a parent that
/// flattens space, in which no offset is that far.
template <class T>
T drop_of(const LegPair& leg, const LegGoal<T>& goal) {
  if (determinant(goal.pose.above_hips) == T(0)) return T(0);
  const TwoBonesT<T> bones{goal.pose.upper.place, goal.pose.lower.place, goal.pose.foot.place};
  const Vec3<T> way = bones.root - goal.ankle;
  const T reach = free_reach(bones), height = std::sqrt(std::max(T(0), reach * reach - way.x * way.x - way.z * way.z));
  return std::clamp(way.y - height, T(0), T(0.25) * static_cast<T>(leg.target_length));
}

template <class T, class Poses>
void hold_leg(const LegPair& leg, const LegGoal<T>& goal, const Vec3<T>& hips_offset, const Poses& poses) {
  const LegPose<T>& pose = goal.pose;
  const TwoBonesT<T> bones{pose.upper.place + hips_offset, pose.lower.place + hips_offset,
                           pose.foot.place + hips_offset};
  const TwoBoneTurnsT<T> turns =
      turn_two_bones(bones, goal.ankle, rotate_vector(pose.upper.rotation, Vec3<T>(leg.bend)));
  const auto set = [&](std::size_t place, const Quat<T>& above, const Quat<T>& rotation) {
    poses.set_rotation(leg.target.joints[place].joint, normalised(quat_conjugate(above) * rotation));
  };
  set(leg.target.upper, pose.upper.above, turns.upper * pose.upper.rotation);
  set(leg.target.lower, turns.upper * pose.lower.above, turns.lower * pose.lower.rotation);
  set(leg.target.foot, turns.lower * pose.foot.above, pose.foot.rotation);
}

/// The goals of all legs. Those of the first legs are kept, so that each is placed once; a leg is no part of another.
template <class T, class Poses>
class LegGoals {
 public:
  LegGoals(const FeetMap& feet, T ground, const Poses& poses) : feet_(feet), ground_(ground), poses_(poses) {
    for (std::size_t i = 0; i < std::min(kKept, feet.legs.size()); ++i) kept_[i] = made(i);
  }
  LegGoal<T> operator[](std::size_t leg) const { return leg < kKept ? kept_[leg] : made(leg); }

 private:
  static constexpr std::size_t kKept = 4;

  LegGoal<T> made(std::size_t leg) const {
    return leg_goal<T>(feet_.legs[leg], static_cast<T>(feet_.ratio), ground_, poses_);
  }

  const FeetMap& feet_;
  T ground_;
  const Poses& poses_;
  std::array<LegGoal<T>, kKept> kept_;
};

/// out  how far the hips go, in the space of their parent
template <class T, class Poses>
Vec3<T> hold_all(const FeetMap& feet, T ground, const Poses& poses) {
  const LegGoals<T, Poses> goals(feet, ground, poses);
  T drop = T(0);
  for (std::size_t i = 0; feet.hips != kNone && i < feet.legs.size(); ++i)
    drop = std::max(drop, drop_of(feet.legs[i], goals[i]));
  Vec3<T> hips_offset(T(0));
  for (std::size_t i = 0; i < feet.legs.size(); ++i) {
    const LegPair& leg = feet.legs[i];
    const LegGoal<T> goal = goals[i];
    if (goal.held == T(0) && drop == T(0)) continue;
    hold_leg(leg, goal, Vec3<T>(T(0), -drop, T(0)), poses);
    if (drop > T(0)) hips_offset = glm::inverse(linear_part(goal.pose.above_hips)) * Vec3<T>(T(0), -drop, T(0));
  }
  return hips_offset;
}

}  // namespace

void hold_feet(const FeetMap& feet, double ground, std::span<const Transformd> pose,
               std::span<Transformd> held) noexcept {
  const FootPoses poses{[&](std::uint32_t j) { return pose[j]; }, [&](std::uint32_t j) { return held[j]; },
                        [&](std::uint32_t j, const Quat<double>& rotation) { held[j].rotation = rotation; }};
  const Vec3<double> hips_offset = hold_all<double>(feet, ground, poses);
  if (feet.hips != kNone) held[feet.hips].translation += hips_offset;
}

ErrorCode check(const HoldFeetJob& job) noexcept {
  if (job.feet == nullptr) return ErrorCode::size_mismatch;
  if (!is_pose_of(job.pose, job.pose.joint_count) || !is_pose_of(job.held, job.held.joint_count))
    return ErrorCode::size_mismatch;
  const auto fits = [](const LegChain& chain, const PoseSpan& pose) {
    return std::all_of(chain.joints.begin(), chain.joints.end(),
                       [&](const LegJoint& joint) { return joint.joint < pose.joint_count; });
  };
  const bool all_fit = std::all_of(job.feet->legs.begin(), job.feet->legs.end(), [&](const LegPair& leg) {
    return fits(leg.source, job.pose) && fits(leg.target, job.held);
  });
  const bool hips_fit = job.feet->hips == kNone || job.feet->hips < job.held.joint_count;
  return all_fit && hips_fit ? ErrorCode::ok : ErrorCode::size_mismatch;
}

void run_unchecked(const HoldFeetJob& job) noexcept {
  assert(check(job) == ErrorCode::ok && "run_unchecked takes only a job that check() accepts");
  const PoseSpan held = job.held;
  const FootPoses poses{[&](std::uint32_t j) { return job.pose.get(j); }, [&](std::uint32_t j) { return held.get(j); },
                        [&](std::uint32_t j, const glm::quat& rotation) { held.set_rotation(j, rotation); }};
  const glm::vec3 hips_offset = hold_all<float>(*job.feet, job.ground, poses);
  if (job.feet->hips == kNone) return;
  held.plane(PoseSpan::tx)[job.feet->hips] += hips_offset.x;
  held.plane(PoseSpan::ty)[job.feet->hips] += hips_offset.y;
  held.plane(PoseSpan::tz)[job.feet->hips] += hips_offset.z;
}

double find_ground(const FeetMap& feet, const Animation& animation, const Skeleton& source) {
  std::vector<double> heights;
  TruthPose pose;
  for (const double time_s : dense_times(animation)) {
    evaluate_truth(animation, source, time_s, pose);
    double lowest = std::numeric_limits<double>::infinity();
    for (const LegPair& leg : feet.legs) {
      const auto at = leg_pose<double>(leg.source, [&](std::uint32_t j) { return pose.local[j]; });
      lowest = std::min(lowest, lowest_height(leg, at));
    }
    heights.push_back(lowest);
  }
  if (feet.legs.empty()) return 0.0;
  const auto ground = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 20);
  std::nth_element(heights.begin(), ground, heights.end());
  return *ground;
}

}  // namespace sinew
