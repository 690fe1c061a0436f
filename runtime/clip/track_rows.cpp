// SPDX-License-Identifier: MIT
#include "runtime/clip/track_rows.h"

#include <algorithm>

#include "runtime/animation/track_sample.h"
#include "runtime/math/quaternion.h"

namespace sinew {
namespace {

void put(TrackBlock& block, std::size_t key, std::size_t plane, std::size_t lane, const glm::vec3& v) {
  float* row = block.rows.writable() + (key * block.plane_count + plane) * block.lane_count + lane;
  for (int c = 0; c < 3; ++c) row[static_cast<std::size_t>(c) * block.lane_count] = v[c];
}

void put(TrackBlock& block, std::size_t key, std::size_t plane, std::size_t lane, const glm::quat& q) {
  float* row = block.rows.writable() + (key * block.plane_count + plane) * block.lane_count + lane;
  for (const float x : {q.x, q.y, q.z, q.w}) {
    *row = x;
    row += block.lane_count;
  }
}

void put(TrackBlock& block, std::size_t key, std::size_t plane, std::size_t lane, float x) {
  block.rows.writable()[(key * block.plane_count + plane) * block.lane_count + lane] = x;
}

/// TrackBlock's `arc` of a key: half the rotation angle to `next` on the short arc, negative if `next` must be
/// negated.
/// in   unit quaternions
float signed_arc(const Quat<double>& key, const Quat<double>& next) noexcept {
  const bool negate = quat_dot(key, next) < 0.0;
  const float arc = std::max(static_cast<float>(arc_angle(key, negate ? -next : next)), kSmallestArc);
  return negate ? -arc : arc;
}

void put_linear_keys(TrackBlock& block, const QuatTrack& track, std::size_t lane) {
  const std::size_t row = block.plane_count * block.lane_count, lanes = block.lane_count;
  float* at = block.rows.writable() + lane;
  Quat<double> key = normalised(quat_cast<double>(track.values.front()));
  for (std::size_t i = 0; i < track.values.size(); ++i, at += row) {
    const glm::quat& q = track.values[i];
    at[0] = q.x;
    at[lanes] = q.y;
    at[2 * lanes] = q.z;
    at[3 * lanes] = q.w;
    at[4 * lanes] = kSmallestArc;
    if (i + 1 == track.values.size()) break;
    const Quat<double> next = normalised(quat_cast<double>(track.values[i + 1]));
    at[4 * lanes] = signed_arc(key, next);
    key = next;
  }
}

void put_squad_segment(TrackBlock& block, const QuatTrack& track, std::size_t key, std::size_t lane) {
  put(block, key, 0, lane, track.values[key]);
  const bool jumps = key + 1 == track.key_count() || !(track.times_s[key + 1] > track.times_s[key]);
  if (jumps) return;  // no sample falls between keys with equal times
  const SquadSegment<double> s = squad_segment<double>(track, key);
  put(block, key, 4, lane, quat_cast<float>(s.begin_control));
  put(block, key, 8, lane, quat_cast<float>(s.end_control));
  put(block, key, 12, lane, quat_dot(s.end, quat_cast<double>(track.values[key + 1])) < 0.0 ? -1.0f : 1.0f);
}

}  // namespace

void fill_lane(TrackBlock& block, const Vec3Track& track, std::size_t lane) {
  const std::size_t per_key = block.plane_count / 3;
  for (std::size_t i = 0; i < track.values.size(); ++i)
    put(block, i / per_key, 3 * (i % per_key), lane, track.values[i]);
}

void fill_lane(TrackBlock& block, const QuatTrack& track, std::size_t lane) {
  if (track.interpolation == Interpolation::linear) return put_linear_keys(block, track, lane);
  const bool cubic = track.interpolation == Interpolation::cubic_spline;
  for (std::size_t i = 0; i < track.values.size(); ++i)
    if (track.interpolation == Interpolation::squad)
      put_squad_segment(block, track, i, lane);
    else
      put(block, cubic ? i / 3 : i, cubic ? 4 * (i % 3) : 0, lane, track.values[i]);
}

void make_room(TrackBlock& block, std::size_t key_count) {
  block.rows.assign(key_count * block.plane_count * block.lane_count + kLanePadding, 0.0f);
}

}  // namespace sinew
