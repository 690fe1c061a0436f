// SPDX-License-Identifier: MIT
#include "importer/tool/convert/resample_clips.h"

#include <algorithm>
#include <cmath>

#include "runtime/animation/track_sample.h"

namespace sinew::tool {
namespace {

/// Both ends of a track, and the multiples of 1 / fps between them.
std::vector<float> key_times(float first, float last, double fps) {
  std::vector<float> times{first};
  for (double k = std::floor(static_cast<double>(first) * fps) + 1.0; k / fps < static_cast<double>(last); k += 1.0)
    if (const auto time = static_cast<float>(k / fps); time > times.back() && time < last) times.push_back(time);
  if (last > first) times.push_back(last);
  return times;
}

template <class V>
bool all_equal(const std::vector<V>& values) {
  return std::all_of(values.begin(), values.end(), [&](const V& v) { return v == values.front(); });
}

glm::vec3 sampled(const Vec3Track& track, double time_s) { return glm::vec3(sample_track<double>(track, time_s)); }
glm::quat sampled(const QuatTrack& track, double time_s) {
  const auto q = sample_track<double>(track, time_s);
  return glm::normalize(
      glm::quat(static_cast<float>(q.w), static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)));
}

bool keeps_keys(Interpolation interpolation, std::size_t keys) {
  return keys < 2 || interpolation == Interpolation::step;
}

template <class V>
void resample(Track<V>& track, double fps) {
  if (keeps_keys(track.interpolation, track.key_count())) return;
  Track<V> out{Interpolation::linear, key_times(track.times_s.front(), track.times_s.back(), fps), {}};
  for (const float time : out.times_s) out.values.push_back(sampled(track, static_cast<double>(time)));
  track = std::move(out);
}

void resample(WeightTrack& track, double fps) {
  if (keeps_keys(track.interpolation, track.key_count())) return;
  WeightTrack out{
      Interpolation::linear, key_times(track.times_s.front(), track.times_s.back(), fps), {}, track.target_count};
  std::vector<double> weights(track.target_count);
  for (const float time : out.times_s) {
    sample_track<double>(track, static_cast<double>(time), weights);
    for (const double weight : weights) out.values.push_back(static_cast<float>(weight));
  }
  track = std::move(out);
}

/// Drops all keys of a constant track but the first. Keeps the last one too, if the clip would otherwise become
/// shorter.
template <class T>
void drop_equal_keys(T& track, std::size_t values_per_key, bool keep_last) {
  if (keeps_keys(track.interpolation, track.key_count()) || track.interpolation != Interpolation::linear) return;
  for (std::size_t i = values_per_key; i < track.values.size(); ++i)
    if (!(track.values[i] == track.values[i - values_per_key])) return;
  const std::size_t keys = keep_last ? 2 : 1;
  track.times_s =
      keep_last ? std::vector{track.times_s.front(), track.times_s.back()} : std::vector{track.times_s.front()};
  track.values.resize(keys * values_per_key);
}

bool varies(const Vec3Track& track) { return !track.empty() && !all_equal(track.values); }
bool varies(const QuatTrack& track) { return !track.empty() && !all_equal(track.values); }

/// True if a track that keeps its keys lasts as long as the clip.
bool lasts(const Animation& animation) {
  const auto reaches = [&](const auto& track, bool kept) {
    return kept && !track.empty() && static_cast<double>(track.times_s.back()) >= animation.duration_s;
  };
  for (const BoneAnimation& bone : animation.bones)
    if (reaches(bone.translation, varies(bone.translation)) || reaches(bone.rotation, varies(bone.rotation)) ||
        reaches(bone.scale, varies(bone.scale)))
      return true;
  return std::any_of(animation.weights.begin(), animation.weights.end(),
                     [&](const WeightAnimation& w) { return reaches(w.weights, true); });
}

}  // namespace

std::vector<Animation> resample_clips(std::vector<Animation> animations, double fps) {
  for (Animation& animation : animations) {
    for (BoneAnimation& bone : animation.bones) {
      resample(bone.translation, fps);
      resample(bone.rotation, fps);
      resample(bone.scale, fps);
    }
    for (WeightAnimation& animated : animation.weights) resample(animated.weights, fps);
    const bool keep_last = !lasts(animation);
    for (BoneAnimation& bone : animation.bones) {
      drop_equal_keys(bone.translation, 1, keep_last);
      drop_equal_keys(bone.rotation, 1, keep_last);
      drop_equal_keys(bone.scale, 1, keep_last);
    }
  }
  return animations;
}

}  // namespace sinew::tool
