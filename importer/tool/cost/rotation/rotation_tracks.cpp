// SPDX-License-Identifier: MIT
#include "importer/tool/cost/rotation/rotation_tracks.h"

#include <algorithm>
#include <cmath>

#include "importer/tool/cost/rotation/incremental_slerp.h"
#include "runtime/animation/track_sample.h"

namespace sinew::cost {
namespace {

/// The values of the keys, each in the hemisphere of the one before.
std::vector<glm::quat> aligned_keys(const QuatTrack& track) {
  const bool cubic = track.interpolation == Interpolation::cubic_spline;
  std::vector<glm::quat> keys;
  for (std::size_t k = 0; k < track.key_count(); ++k) {
    const glm::quat value = normalised(track.values[cubic ? 3 * k + 1 : k]);
    keys.push_back(keys.empty() ? value : aligned_with(keys.back(), value));
  }
  return keys;
}

/// Slope at key k of the parabola through the keys around it; at an end or a jump, the slope of the only side.
glm::quat slope_at(const std::vector<glm::quat>& keys, const std::vector<float>& times_s, std::size_t k) {
  const glm::quat none(0.0f, 0.0f, 0.0f, 0.0f);
  const float before = k > 0 ? times_s[k] - times_s[k - 1] : 0.0f;
  const float after = k + 1 < keys.size() ? times_s[k + 1] - times_s[k] : 0.0f;
  const glm::quat in = before > 0.0f ? (keys[k] - keys[k - 1]) / before : none;
  const glm::quat out = after > 0.0f ? (keys[k + 1] - keys[k]) / after : none;
  if (!(before > 0.0f)) return out;
  if (!(after > 0.0f)) return in;
  return (in * after + out * before) / (before + after);
}

QuatTrack rebuilt(const QuatTrack& track, Interpolation interpolation) {
  if (track.interpolation == interpolation) return track;
  const std::vector<glm::quat> keys = aligned_keys(track);
  QuatTrack out{interpolation, track.times_s, {}};
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const glm::quat slope = slope_at(keys, track.times_s, k);
    if (interpolation == Interpolation::cubic_spline)
      out.values.insert(out.values.end(), {slope, keys[k], slope});
    else
      out.values.push_back(keys[k]);
  }
  return out;
}

}  // namespace

bool is_between_keys(const QuatTrack& track) {
  if (track.key_count() < 2 || track.interpolation == Interpolation::step) return false;
  return std::any_of(track.values.begin(), track.values.end(),
                     [&](const glm::quat& q) { return q != track.values.front(); });
}

Animation rotations_only(const Animation& animation, Interpolation interpolation) {
  Animation out;
  out.duration_s = animation.duration_s;
  for (const BoneAnimation& bone : animation.bones) {
    if (!is_between_keys(bone.rotation)) continue;
    BoneAnimation& turned = out.bones.emplace_back();
    turned.joint = bone.joint;
    turned.rotation = rebuilt(bone.rotation, interpolation);
  }
  return out;
}

Crowd crowd_of(const Skeleton& skeleton, const Animation& animation, std::size_t copies) {
  Crowd crowd{skeleton, animation};
  const auto joints = static_cast<std::uint32_t>(skeleton.joint_count());
  for (std::uint32_t copy = 1; copy < copies; ++copy) {
    for (std::uint32_t j = 0; j < joints; ++j) {
      crowd.skeleton.rest.push_back(skeleton.rest[j]);
      crowd.skeleton.parents.push_back(skeleton.parents[j] == kNone ? kNone : skeleton.parents[j] + copy * joints);
      crowd.skeleton.fixed_matrix_of.push_back(skeleton.fixed_matrix_of[j]);
    }
    for (BoneAnimation bone : animation.bones) {
      bone.joint += copy * joints;
      crowd.animation.bones.push_back(std::move(bone));
    }
  }
  return crowd;
}

void walk_track(const QuatTrack& track, double fps, std::span<glm::quat> frames) {
  for (std::size_t f = 0; f < frames.size();) {
    const KeyPosition at = locate_key(track.times_s, static_cast<double>(f) / fps);
    if (at.on_key) {
      frames[f++] = track.values[at.key];
      continue;
    }
    const double steps_left = (1.0 - at.fraction) * at.interval_s * fps;
    const auto inside = static_cast<std::size_t>(std::max(0.0, std::ceil(steps_left) - 1.0));
    const std::size_t more = std::min(frames.size() - 1 - f, inside);
    const double last = std::min(1.0, at.fraction + static_cast<double>(more) / (at.interval_s * fps));
    const glm::quat& before = track.values[at.key];
    const glm::quat& after = track.values[at.key + 1];
    frames[f] = slerp_short_arc(before, after, static_cast<float>(at.fraction));
    if (more > 0) {
      IncrementalSlerp<float> walk(frames[f], slerp_short_arc(before, after, static_cast<float>(last)),
                                   static_cast<int>(more));
      for (std::size_t i = 1; i <= more; ++i) {
        walk.advance();
        frames[f + i] = walk.current();
      }
    }
    f += more + 1;
  }
}

}  // namespace sinew::cost
