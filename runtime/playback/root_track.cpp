// SPDX-License-Identifier: MIT
#include "runtime/playback/root_track.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/base/contract.h"
#include "runtime/playback/carried_motion.h"
#include "runtime/playback/rigid_keys.h"

namespace sinew {
namespace {

RigidKey rigid_key(const RootTrack::Key& key) noexcept {
  return {key.time_s, Vec3<double>(key.translation), quat_cast<double>(key.turn)};
}

/// All key times that a motion of the joint may have, in order.
std::vector<double> authored_times(const BoneAnimation& root, std::span<const RootTrack::Key> keys = {}) {
  std::vector<double> times;
  for (const auto* track : {&root.translation.times_s, &root.rotation.times_s})
    times.insert(times.end(), track->begin(), track->end());
  for (const RootTrack::Key& key : keys) times.push_back(static_cast<double>(key.time_s));
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace

RootTrack RootTrack::make(const BoneAnimation& root, const Transform& rest, const RootMotionParts& parts,
                          double tolerance) {
  CONTRACT(tolerance > 0.0);
  const auto motion = [&](double time_s) { return root_place(root, rest, parts, time_s); };
  RigidKeySearch search(motion, tolerance);
  RootTrack track;
  for (const RigidKey& key : search.keys(authored_times(root)))
    track.keys_.push_back({static_cast<float>(key.time_s), Vec3<float>(key.translation), quat_cast<float>(key.turn)});
  for (std::size_t i = 0; i + 1 < track.keys_.size(); ++i) {
    const double from_s = track.keys_[i].time_s, to_s = track.keys_[i + 1].time_s;
    for (int c = 0; c < search.kChecksInInterval; ++c) {
      const double time_s = from_s + (to_s - from_s) * c / search.kChecksInInterval;
      const DualQuatd found = track.place(time_s);
      track.measured_error_ = std::max(
          track.measured_error_, distance({time_s, translation_of(found), found.real}, search.key_at(time_s, time_s)));
    }
  }
  return track;
}

DualQuatd RootTrack::place(double time_s) const noexcept {
  if (keys_.empty()) return {};
  const auto next = std::upper_bound(keys_.begin(), keys_.end(), time_s, [](double time, const Key& key) {
    return time < static_cast<double>(key.time_s);
  });
  RigidKey found = rigid_key(next == keys_.begin() ? keys_.front() : *(next - 1));
  if (next != keys_.begin() && next != keys_.end()) found = between(found, rigid_key(*next), time_s);
  return dual_quat_from(normalised(found.turn), found.translation);
}

BoneAnimation bake_out_root(const BoneAnimation& root, const Transform& rest, const RootTrack& track,
                            double tolerance) {
  CONTRACT(tolerance > 0.0);
  const auto motion = [&](double time_s) {
    const Transformd local = root.interpolate<double>(
        time_s, {Vec3<double>(rest.translation), quat_cast<double>(rest.rotation), Vec3<double>(rest.scale)});
    return normalised(dual_quat_conjugate(track.place(time_s)) * dual_quat_from(local.rotation, local.translation));
  };
  BoneAnimation out{.joint = root.joint, .translation = {}, .rotation = {}, .scale = root.scale};
  RigidKeySearch search(motion, tolerance);
  for (const RigidKey& key : search.keys(authored_times(root, track.keys()))) {
    out.translation.times_s.push_back(static_cast<float>(key.time_s));
    out.translation.values.push_back(Vec3<float>(key.translation));
    out.rotation.values.push_back(quat_cast<float>(key.turn));
  }
  out.rotation.times_s = out.translation.times_s;
  return out;
}

DualQuatd RootTrack::motion(const PlaybackStep& step) const noexcept {
  return carried_motion([this](double time_s) { return place(time_s); }, step);
}

}  // namespace sinew
