// SPDX-License-Identifier: MIT
#include "runtime/retarget/retarget_animation.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "runtime/animation/constant_tracks.h"
#include "runtime/animation/joint_tracks.h"
#include "runtime/animation/track_sample.h"
#include "runtime/retarget/rest_transform.h"

namespace sinew {
namespace {

using Quatd = Quat<double>;
using Vec3d = Vec3<double>;

/// The transform of a joint relative to its nearest mapped ancestor.
struct RelativeTransform {
  Quatd rotation = quat_identity<double>();
  Vec3d place{0.0};
};

/// in   local(j)  returns the local transform of a source joint
template <class Local>
RelativeTransform relative_transform(const MappedJoint& joint, const Skeleton& source, const Local& local) {
  RelativeTransform relative;
  for (std::uint32_t j = joint.source; j != joint.above_source; j = source.parents[j]) {
    const Transformd own = local(j);
    relative.place =
        j == joint.source ? own.translation : own.translation + rotate_vector(own.rotation, own.scale * relative.place);
    relative.rotation = j == joint.source ? own.rotation : own.rotation * relative.rotation;
  }
  return relative;
}

/// in   own  place of the target in the reference pose
Vec3d mapped_place(const MappedJoint& joint, const Vec3d& own, const Vec3d& place) noexcept {
  const Vec3d offset = own - joint.translation * joint.source_place;
  return joint.translation * place + offset;
}

glm::quat in_float(const Quatd& q) noexcept { return quat_cast<float>(q); }

/// Makes the tracks of one joint of the target.
class JointBake {
 public:
  JointBake(const MappedJoint& joint, const SkeletonMap& map, const Skeleton& source, const Skeleton& target,
            std::span<const JointTracks> tracks)
      : joint_(joint),
        map_(map),
        source_(source),
        own_(reference_transform(target, map.target_pose, joint.target)),
        rest_rotation_(rest_transform(target, joint.target).rotation),
        tracks_(tracks) {
    for (std::uint32_t j = joint.source; j != joint.above_source; j = source.parents[j]) path_.push_back(j);
  }

  BoneAnimation bake() const {
    BoneAnimation bone;
    bone.joint = joint_.target;
    bake_rotation(bone.rotation);
    if (joint_.moves) bake_translation(bone.translation);
    if (map_.by_names && path_.size() == 1) bake_scale(bone.scale);
    return bone;
  }

 private:
  Transformd local_at(std::uint32_t j, double time_s) const {
    Transformd local = rest_transform(source_, j);
    const JointTracks& of_joint = tracks_[j];
    if (of_joint.translation != nullptr) local.translation = sample_track<double>(*of_joint.translation, time_s);
    if (of_joint.rotation != nullptr) local.rotation = sample_track<double>(*of_joint.rotation, time_s);
    if (of_joint.scale != nullptr) local.scale = sample_track<double>(*of_joint.scale, time_s);
    return local;
  }
  RelativeTransform relative_transform_at(double time_s) const {
    return relative_transform(joint_, source_, [&](std::uint32_t j) { return local_at(j, time_s); });
  }
  Quatd mapped(const Quatd& seen_rotation) const { return joint_.before * seen_rotation * joint_.after; }

  void bake_rotation(QuatTrack& track) const {
    std::vector<std::uint32_t> moved;
    for (const std::uint32_t j : path_)
      if (tracks_[j].rotation != nullptr) moved.push_back(j);
    if (moved.size() > 1) return sample_rotation(moved, track);
    if (moved.empty()) {
      const Quatd held = normalised(mapped(relative_transform_at(0.0).rotation));
      constexpr double kSame = 1e-6;
      if (rotation_angle_between(held, rest_rotation_) > kSame) track = {Interpolation::step, {0.0f}, {in_float(held)}};
      return;
    }
    Quatd above = quat_identity<double>(), below = quat_identity<double>();
    bool is_above = false;  // true while walking up the path
    for (const std::uint32_t j : path_) {
      if (j == moved[0])
        is_above = true;
      else if (is_above)
        above = rest_transform(source_, j).rotation * above;
      else
        below = rest_transform(source_, j).rotation * below;
    }
    const Quatd before = joint_.before * above, after = below * joint_.after;
    track = *tracks_[moved[0]].rotation;
    for (glm::quat& q : track.values) q = in_float(before * quat_cast<double>(q) * after);
  }

  void sample_rotation(std::span<const std::uint32_t> moved, QuatTrack& track) const {
    std::vector<float> times;
    for (const std::uint32_t j : moved) add_times(*tracks_[j].rotation, times);
    track = {Interpolation::linear, with_midpoints(std::move(times)), {}};
    for (const float t : track.times_s)
      track.values.push_back(in_float(normalised(mapped(relative_transform_at(static_cast<double>(t)).rotation))));
  }

  /// The translation follows a single track if no joint above it on the path is animated.
  void bake_translation(Vec3Track& track) const {
    const JointTracks& own = tracks_[joint_.source];
    std::vector<float> times;
    for (std::size_t i = 1; i < path_.size(); ++i) {
      const JointTracks& above = tracks_[path_[i]];
      if (above.translation != nullptr) add_times(*above.translation, times);
      if (above.rotation != nullptr) add_times(*above.rotation, times);
      if (above.scale != nullptr) add_times(*above.scale, times);
    }
    if (times.empty() && own.translation == nullptr) return;
    if (times.empty()) return map_translation(*own.translation, track);
    if (own.translation != nullptr) add_times(*own.translation, times);
    track = {Interpolation::linear, with_midpoints(std::move(times)), {}};
    for (const float t : track.times_s)
      track.values.emplace_back(
          mapped_place(joint_, own_.translation, relative_transform_at(static_cast<double>(t)).place));
  }

  void map_translation(const Vec3Track& from, Vec3Track& track) const {
    track = from;
    const auto place_of = [&](const Vec3d& own) {
      return relative_transform(joint_, source_,
                                [&](std::uint32_t j) {
                                  Transformd local = rest_transform(source_, j);
                                  if (j == joint_.source) local.translation = own;
                                  return local;
                                })
          .place;
    };
    const Vec3d at_zero = mapped_place(joint_, own_.translation, place_of(Vec3d(0.0)));
    for (std::size_t i = 0; i < track.values.size(); ++i) {
      const bool tangent = track.interpolation == Interpolation::cubic_spline && i % 3 != 1;
      const Vec3d place = mapped_place(joint_, own_.translation, place_of(Vec3d(from.values[i])));
      track.values[i] = glm::vec3(tangent ? place - at_zero : place);
    }
  }

  void bake_scale(Vec3Track& track) const {
    const Vec3Track* from = tracks_[joint_.source].scale;
    if (from == nullptr) return;
    track = *from;
    const Vec3d ratio = own_.scale / reference_transform(source_, map_.source_pose, joint_.source).scale;
    for (glm::vec3& s : track.values) s = glm::vec3(Vec3d(s) * ratio);
  }

  template <class V>
  static void add_times(const Track<V>& track, std::vector<float>& times) {
    times.insert(times.end(), track.times_s.begin(), track.times_s.end());
  }
  static std::vector<float> with_midpoints(std::vector<float> times) {
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    const std::size_t count = times.size();
    for (std::size_t i = 1; i < count; ++i) times.push_back(0.5f * (times[i - 1] + times[i]));
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
  }

  const MappedJoint& joint_;
  const SkeletonMap& map_;
  const Skeleton& source_;
  Transformd own_;       // transform of the target joint in the reference pose
  Quatd rest_rotation_;  // rest rotation of the target joint
  std::span<const JointTracks> tracks_;
  std::vector<std::uint32_t> path_;  // source joints, from the joint up to its mapped ancestor
};

}  // namespace

void retarget_pose(const SkeletonMap& map, const Skeleton& source, const Skeleton& target,
                   std::span<const Transformd> pose, std::span<Transformd> out) noexcept {
  for (std::uint32_t j = 0; j < out.size(); ++j) out[j] = reference_transform(target, map.target_pose, j);
  for (const MappedJoint& joint : map.joints) {
    const auto local = [&](std::uint32_t j) {
      return source.fixed_matrix_of[j] == kNone ? pose[j] : rest_transform(source, j);
    };
    const RelativeTransform from = relative_transform(joint, source, local);
    Transformd& to = out[joint.target];
    to.rotation = normalised(joint.before * from.rotation * joint.after);
    if (joint.moves) to.translation = mapped_place(joint, to.translation, from.place);
    if (map.by_names && source.parents[joint.source] == joint.above_source)
      to.scale *= local(joint.source).scale / reference_transform(source, map.source_pose, joint.source).scale;
  }
}

Animation retarget_animation(const Animation& animation, const SkeletonMap& map, const Skeleton& source,
                             const Skeleton& target) {
  std::vector<JointTracks> tracks = tracks_by_joint(animation, source.joint_count());
  for (std::size_t j = 0; j < tracks.size(); ++j)
    if (source.fixed_matrix_of[j] != kNone) tracks[j] = {};  // a fixed matrix replaces the tracks
  Animation out{animation.name, animation.duration_s, {}, {}, {}, animation.annotations};
  for (const MappedJoint& joint : map.joints) {
    BoneAnimation bone = JointBake(joint, map, source, target, tracks).bake();
    if (!bone.empty()) out.bones.push_back(std::move(bone));
  }
  if (map.source_pose.empty() && map.target_pose.empty()) return out;
  std::vector<Transformd> rest(source.joint_count()), still(target.joint_count());
  for (std::uint32_t j = 0; j < rest.size(); ++j) rest[j] = rest_transform(source, j);
  retarget_pose(map, source, target, rest, still);
  std::vector<Transform> held;
  for (const Transformd& t : still)
    held.push_back({glm::vec3(t.translation), in_float(t.rotation), glm::vec3(t.scale)});
  add_constant_tracks(held, target, out);
  return out;
}

RetargetError measure_retarget(const Animation& retargeted, const Animation& animation, const SkeletonMap& map,
                               const Skeleton& source, const Skeleton& target, double per_second) {
  RetargetError error;
  TruthPose from, found;
  std::vector<Transformd> expected(target.joint_count());
  const auto count = static_cast<std::size_t>(std::ceil(animation.duration_s * per_second));
  for (std::size_t i = 0; i <= count; ++i) {
    const double time_s = std::min(static_cast<double>(i) / per_second, animation.duration_s);
    evaluate_truth(animation, source, time_s, from);
    evaluate_truth(retargeted, target, time_s, found);
    retarget_pose(map, source, target, from.local, expected);
    for (const MappedJoint& joint : map.joints) {
      const Transformd &a = expected[joint.target], &b = found.local[joint.target];
      const double angle = rotation_angle_between(a.rotation, b.rotation);
      if (angle > error.angle_rad || error.joint == kNone) error.joint = joint.target;
      error.angle_rad = std::max(error.angle_rad, angle);
      error.distance = std::max(error.distance, safe_length(a.translation - b.translation));
    }
  }
  return error;
}

}  // namespace sinew
