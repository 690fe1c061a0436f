// SPDX-License-Identifier: MIT
#include "runtime/animation/truth_pose.h"

#include "runtime/animation/track_sample.h"

namespace sinew {
namespace {

/// locate_key(), where `key` is likely the key at or before the time. It becomes that key.
KeyPosition locate_near(std::span<const float> times_s, double time_s, std::size_t& key) noexcept {
  const auto time_of = [&](std::size_t i) { return static_cast<double>(times_s[i]); };
  const bool is_there = key + 1 < times_s.size() && time_of(key) <= time_s && time_s < time_of(key + 1);
  const KeyPosition at = is_there ? position_after(times_s, key, time_s) : locate_key(times_s, time_s);
  key = at.key;
  return at;
}

Vec3<double> value_near(const Vec3Track& track, double time_s, std::size_t& key) noexcept {
  const KeyPosition at = locate_near(track.times_s, time_s, key);
  if (at.on_key) return Vec3<double>(track.values[value_row(track.interpolation, at.key)]);
  return between_keys<double>(track, at.key, at.key + 1, at.fraction, at.interval_s);
}

}  // namespace

void model_from_local(const Skeleton& skeleton, std::span<const Transformd> local, std::span<Affined> model) {
  for (std::size_t j = 0; j < local.size(); ++j) {
    const std::uint32_t fixed = skeleton.fixed_matrix_of[j], parent = skeleton.parents[j];
    model[j] = fixed == kNone ? affine_from_transform(local[j]) : affine_cast<double>(skeleton.fixed_matrices[fixed]);
    if (parent != kNone) model[j] = model[parent] * model[j];
  }
}

void evaluate_truth(const Animation& animation, const Skeleton& skeleton, double time_s, TruthPose& out) {
  const std::size_t joints = skeleton.joint_count();
  out.local.resize(joints);
  out.model.resize(joints);
  for (std::size_t j = 0; j < joints; ++j) out.local[j] = in_double(skeleton.rest[j]);
  // If two tracks move the same property, the last one counts, as in compiled clips.
  for (const BoneAnimation& bone : animation.bones)
    out.local[bone.joint] = bone.interpolate<double>(time_s, out.local[bone.joint]);
  model_from_local(skeleton, out.local, out.model);
}

TruthCursor::TruthCursor(const Animation& animation, const Skeleton& skeleton)
    : animation_(animation), skeleton_(skeleton), bones_(animation.bones.size()) {}

void TruthCursor::local_at(double time_s, std::span<Transformd> local) {
  for (std::size_t j = 0; j < local.size(); ++j) local[j] = in_double(skeleton_.rest[j]);
  for (std::size_t b = 0; b < bones_.size(); ++b) {
    const BoneAnimation& bone = animation_.bones[b];
    Transformd& out = local[bone.joint];
    if (!bone.translation.empty()) out.translation = value_near(bone.translation, time_s, bones_[b].translation);
    if (!bone.rotation.empty()) out.rotation = rotation_at(bone.rotation, time_s, bones_[b]);
    if (!bone.scale.empty()) out.scale = value_near(bone.scale, time_s, bones_[b].scale);
  }
}

void TruthCursor::evaluate(double time_s, TruthPose& out) {
  out.local.resize(skeleton_.joint_count());
  out.model.resize(skeleton_.joint_count());
  local_at(time_s, out.local);
  model_from_local(skeleton_, out.local, out.model);
}

Quat<double> TruthCursor::rotation_at(const QuatTrack& track, double time_s, Bone& bone) noexcept {
  if (track.interpolation != Interpolation::linear) return sample_track<double>(track, time_s);
  const KeyPosition at = locate_near(track.times_s, time_s, bone.rotation);
  const Quat<double> from = quat_cast<double>(track.values[at.key]);
  if (at.on_key) return from;
  const Quat<double> to = quat_cast<double>(track.values[at.key + 1]);
  if (!bone.arc || bone.arc->first != at.key) bone.arc.emplace(at.key, SlerpArc<double>(from, to));
  return bone.arc->second.at(at.fraction);
}

}  // namespace sinew
