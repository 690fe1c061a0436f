// SPDX-License-Identifier: MIT
#include "runtime/retarget/share_twist.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "runtime/animation/joint_tracks.h"
#include "runtime/animation/track_sample.h"
#include "runtime/math/swing_twist.h"
#include "runtime/retarget/dense_times.h"

namespace sinew {
namespace {

/// The rotation of a twist joint for that of its driver.
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
    QuatTrack track = shared_track(twist, *driver);  // before the animation grows
    last_bone_of(animation, twist.joint).rotation = std::move(track);
  }
}

}  // namespace sinew
