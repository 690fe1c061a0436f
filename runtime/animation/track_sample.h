// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <span>

#include "runtime/animation/track.h"
#include "runtime/math/interpolate.h"

/// Evaluates authoring tracks in float or double. The double results are the truth for compiled clips.
namespace sinew {

/// Position of a time among the keys. It is on `key` itself (also before the first and after the last key), or between
/// `key` and the next one. Then it is at `fraction` (0 to 1) of an interval of `interval_s` > 0.
struct KeyPosition {
  std::size_t key = 0;
  bool on_key = true;
  double fraction = 0.0;
  double interval_s = 0.0;
};

/// Position of `time_s` if `key` is the last key at or before it. The subtraction is in double, since float would lose
/// digits late in a long clip.
inline KeyPosition position_after(std::span<const float> times_s, std::size_t key, double time_s) noexcept {
  const double begin = static_cast<double>(times_s[key]);
  if (time_s == begin || key + 1 == times_s.size()) return {key, true, 0.0, 0.0};
  const double interval = static_cast<double>(times_s[key + 1]) - begin;
  return {key, false, (time_s - begin) / interval, interval};
}

/// Position of a time. If keys have equal times, the last one counts: the value jumps there.
/// in   times_s[K]  K >= 1, never decreasing;   time_s  NaN gives the first key      cost O(log K)
inline KeyPosition locate_key(std::span<const float> times_s, double time_s) noexcept {
  if (!(time_s >= static_cast<double>(times_s.front()))) return {};
  const auto after = std::upper_bound(times_s.begin(), times_s.end(), time_s,
                                      [](double t, float key) { return t < static_cast<double>(key); });
  return position_after(times_s, static_cast<std::size_t>(after - times_s.begin()) - 1, time_s);
}

/// The four quaternions of squad between key k and k + 1; `end` and `end_control` are on the hemisphere of `begin`.
template <class T>
struct SquadSegment {
  Quat<T> begin, begin_control, end_control, end;
};

/// Computes the control points from the neighbouring keys. At the ends of the track and at jumps a neighbour is
/// missing: there the key itself is the control point.
template <class T>
SquadSegment<T> squad_segment(const QuatTrack& track, std::size_t k) noexcept {
  const auto& times = track.times_s;
  const auto key = [&](std::size_t i) { return normalised(quat_cast<T>(track.values[i])); };
  const auto apart = [&](std::size_t i) {
    return static_cast<T>(static_cast<double>(times[i + 1]) - static_cast<double>(times[i]));
  };
  const T length = apart(k);
  SquadSegment<T> s;
  s.begin = s.begin_control = key(k);
  s.end = s.end_control = aligned_with(s.begin, key(k + 1));
  if (k > 0 && apart(k - 1) > T(0))
    s.begin_control =
        squad_controls_uneven(aligned_with(s.begin, key(k - 1)), s.begin, s.end, apart(k - 1), length).outgoing;
  if (k + 2 < times.size() && apart(k + 1) > T(0))
    s.end_control =
        squad_controls_uneven(s.begin, s.end, aligned_with(s.end, key(k + 2)), length, apart(k + 1)).incoming;
  return s;
}

/// Row of a key's value in `values`. Cubic keys have three rows: in-tangent, value, out-tangent.
inline std::size_t value_row(Interpolation interpolation, std::size_t key) noexcept {
  return interpolation == Interpolation::cubic_spline ? 3 * key + 1 : key;
}

/// Value at `fraction` between the keys `a` and `b`, ignoring keys between them. Squad tracks use slerp here.
/// eq   glTF 2.0, Appendix C.   in  0 < fraction < 1 of interval_s seconds
template <class T>
Vec3<T> between_keys(const Vec3Track& track, std::size_t a, std::size_t b, double fraction,
                     double interval_s) noexcept {
  const std::size_t from = value_row(track.interpolation, a), to = value_row(track.interpolation, b);
  const auto value = [&](std::size_t i) { return Vec3<T>(track.values[i]); };
  if (track.interpolation == Interpolation::step) return value(from);
  if (track.interpolation == Interpolation::cubic_spline)
    return hermite(value(from), value(from + 1), value(to - 1), value(to), static_cast<T>(fraction),
                   static_cast<T>(interval_s));
  return lerp(value(from), value(to), static_cast<T>(fraction));
}

/// As above, for rotations: slerp on the short arc, or a Hermite spline that is then normalised.
template <class T>
Quat<T> between_keys(const QuatTrack& track, std::size_t a, std::size_t b, double fraction,
                     double interval_s) noexcept {
  const std::size_t from = value_row(track.interpolation, a), to = value_row(track.interpolation, b);
  const auto value = [&](std::size_t i) { return quat_cast<T>(track.values[i]); };
  if (track.interpolation == Interpolation::step) return value(from);
  if (track.interpolation == Interpolation::cubic_spline)
    return hermite_rotation(value(from), value(from + 1), value(to - 1), value(to), static_cast<T>(fraction),
                            static_cast<T>(interval_s));
  return slerp_short_arc(value(from), value(to), static_cast<T>(fraction));
}

/// As above, for the weight with index `weight`.
template <class T>
T between_keys(const WeightTrack& track, std::size_t a, std::size_t b, double fraction, double interval_s,
               std::size_t weight) noexcept {
  const std::size_t from = value_row(track.interpolation, a), to = value_row(track.interpolation, b);
  const auto value = [&](std::size_t row) { return static_cast<T>(track.values[row * track.target_count + weight]); };
  if (track.interpolation == Interpolation::step) return value(from);
  if (track.interpolation == Interpolation::cubic_spline)
    return hermite(value(from), value(from + 1), value(to - 1), value(to), static_cast<T>(fraction),
                   static_cast<T>(interval_s));
  return lerp(value(from), value(to), static_cast<T>(fraction));
}

/// The value of a track at a time.     in  track  passed check(Track)
template <class T>
Vec3<T> sample_track(const Vec3Track& track, double time_s) noexcept {
  const KeyPosition at = locate_key(track.times_s, time_s);
  if (at.on_key) return Vec3<T>(track.values[value_row(track.interpolation, at.key)]);
  return between_keys<T>(track, at.key, at.key + 1, at.fraction, at.interval_s);
}

/// As above, for rotations.     eq  squad by Shoemake 1987
template <class T>
Quat<T> sample_track(const QuatTrack& track, double time_s) noexcept {
  const KeyPosition at = locate_key(track.times_s, time_s);
  if (at.on_key) return quat_cast<T>(track.values[value_row(track.interpolation, at.key)]);
  if (track.interpolation != Interpolation::squad)
    return between_keys<T>(track, at.key, at.key + 1, at.fraction, at.interval_s);
  const SquadSegment<T> c = squad_segment<T>(track, at.key);
  return squad(c.begin, c.begin_control, c.end_control, c.end, static_cast<T>(at.fraction));
}

/// As above, for all weights of a track.     out  weights[track.target_count]
template <class T>
void sample_track(const WeightTrack& track, double time_s, std::span<T> weights) noexcept {
  const KeyPosition at = locate_key(track.times_s, time_s);
  for (std::size_t i = 0; i < track.target_count; ++i)
    weights[i] = at.on_key
                     ? static_cast<T>(track.values[value_row(track.interpolation, at.key) * track.target_count + i])
                     : between_keys<T>(track, at.key, at.key + 1, at.fraction, at.interval_s, i);
}

}  // namespace sinew
