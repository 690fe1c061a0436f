// SPDX-License-Identifier: MIT
#include "runtime/retarget/share_twist.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <string>

#include "runtime/animation/joint_tracks.h"
#include "runtime/animation/track_sample.h"
#include "runtime/math/swing_twist.h"
#include "runtime/retarget/dense_times.h"
#include "runtime/retarget/humanoid_bones.h"
#include "runtime/retarget/name_words.h"
#include "runtime/retarget/rest_transform.h"

namespace sinew {
namespace {

/// A limb bone: the joint that turns it, and the joint at its far end.
struct Limb {
  std::uint32_t joint = kNone, tip = kNone;
  bool is_upper = false;
};

std::vector<Limb> limbs_of(const Skeleton& skeleton, const std::vector<std::uint32_t>& bones) {
  std::vector<Limb> limbs;
  for (const std::string side : {"left", "right"}) {
    const auto add = [&](const char* joint, const char* tip, bool is_upper) {
      const Limb limb{bones[humanoid_bone(side + joint)], bones[humanoid_bone(side + tip)], is_upper};
      if (limb.joint != kNone && limb.tip != kNone && skeleton.parents[limb.tip] == limb.joint) limbs.push_back(limb);
    };
    add("UpperArm", "LowerArm", true);
    add("LowerArm", "Hand", false);
    add("UpperLeg", "LowerLeg", true);
    add("LowerLeg", "Foot", false);
  }
  return limbs;
}

bool names_a_twist_joint(const std::string& name) {
  const std::vector<std::string> words = name_words(name);
  return std::any_of(words.begin(), words.end(),
                     [](const std::string& word) { return word.find("twist") != std::string::npos || word == "roll"; });
}

/// Makes the twist joint of a limb. Empty if the joint does not lie along the bone.
std::optional<TwistJoint> twist_joint(const Skeleton& skeleton, std::span<const Transform> reference, const Limb& limb,
                                      std::uint32_t joint) {
  constexpr double kBeyond = 0.1, kAside = 0.25;  // tolerances, as fractions of the bone's length
  const Vec3<double> bone = reference_transform(skeleton, reference, limb.tip).translation,
                     place = reference_transform(skeleton, reference, joint).translation;
  const double length = safe_length(bone);
  if (!(length > 0.0)) return std::nullopt;
  TwistJoint twist;
  twist.axis = bone / length;
  const double along = glm::dot(place, twist.axis) / length;
  if (along < -kBeyond || along > 1.0 + kBeyond) return std::nullopt;
  if (safe_length(place - twist.axis * (along * length)) > kAside * length) return std::nullopt;
  twist.joint = joint;
  twist.driver = limb.is_upper ? limb.joint : limb.tip;
  twist.is_below_driver = limb.is_upper;
  twist.share = std::clamp(along, 0.0, 1.0) - (limb.is_upper ? 1.0 : 0.0);
  twist.rest = normalised(reference_transform(skeleton, reference, joint).rotation);
  twist.driver_rest = normalised(reference_transform(skeleton, reference, twist.driver).rotation);
  return twist;
}

/// The rotation of a twist joint for a given rotation of its driver.
Quat<double> shared(const TwistJoint& twist, const Quat<double>& driver) noexcept {
  const Quat<double> unrest = quat_conjugate(twist.driver_rest);
  const HalfTwistT<double> half = half_twist(twist.is_below_driver ? unrest * driver : driver * unrest, twist.axis);
  const double sign = half.cosine < 0.0 ? -1.0 : 1.0;
  const double half_angle = twist.share * std::atan2(sign * half.sine, sign * half.cosine);
  const Vec3<double> v = twist.axis * std::sin(half_angle);
  return normalised(quat_xyzw(v.x, v.y, v.z, std::cos(half_angle)) * twist.rest);
}

QuatTrack shared_track(const TwistJoint& twist, const QuatTrack& driver) {
  const bool steps = driver.interpolation == Interpolation::step;
  const std::vector<double> keys(driver.times_s.begin(), driver.times_s.end());
  QuatTrack track{steps ? Interpolation::step : Interpolation::linear, {}, {}};
  for (const double time_s : steps ? keys : dense_times(keys)) {
    track.times_s.push_back(static_cast<float>(time_s));
    const Quat<double> turned = normalised(sample_track<double>(driver, time_s));
    track.values.push_back(quat_cast<float>(shared(twist, turned)));
  }
  return track;
}

}  // namespace

TwistMap make_twist_map(const SkeletonMap& map, const Skeleton& target) {
  TwistMap twists;
  const std::vector<Limb> limbs = limbs_of(target, map.target_bones);
  const auto is_fixed = [&](std::uint32_t j) { return target.fixed_matrix_of[j] != kNone; };
  for (const std::uint32_t joint : map.unmapped_target) {
    const auto limb =
        std::find_if(limbs.begin(), limbs.end(), [&](const Limb& l) { return target.parents[joint] == l.joint; });
    if (limb == limbs.end() || is_fixed(joint) || !names_a_twist_joint(target.names[joint])) continue;
    const auto twist = twist_joint(target, map.target_pose, *limb, joint);
    if (twist && !is_fixed(twist->driver)) twists.joints.push_back(*twist);
  }
  return twists;
}

void share_twist(const TwistMap& twists, std::span<Transformd> pose) noexcept {
  for (const TwistJoint& twist : twists.joints) pose[twist.joint].rotation = shared(twist, pose[twist.driver].rotation);
}

ErrorCode check(const ShareTwistJob& job) noexcept {
  if (job.twists == nullptr || !is_pose_of(job.pose, job.pose.joint_count)) return ErrorCode::size_mismatch;
  const bool all_fit = std::all_of(job.twists->joints.begin(), job.twists->joints.end(), [&](const TwistJoint& twist) {
    return twist.joint < job.pose.joint_count && twist.driver < job.pose.joint_count;
  });
  return all_fit ? ErrorCode::ok : ErrorCode::size_mismatch;
}

void run_unchecked(const ShareTwistJob& job) noexcept {
  assert(check(job) == ErrorCode::ok && "run_unchecked takes only a job that check() accepts");
  for (const TwistJoint& twist : job.twists->joints)
    job.pose.set_rotation(twist.joint,
                          quat_cast<float>(shared(twist, quat_cast<double>(job.pose.get(twist.driver).rotation))));
}

void share_twist(const TwistMap& twists, Animation& animation) {
  for (const TwistJoint& twist : twists.joints) {
    const QuatTrack* driver = tracks_of_joint(animation, twist.driver).rotation;
    if (driver == nullptr) continue;
    QuatTrack track = shared_track(twist, *driver);  // made first: adding a bone would invalidate `driver`
    last_bone_of(animation, twist.joint).rotation = std::move(track);
  }
}

}  // namespace sinew
