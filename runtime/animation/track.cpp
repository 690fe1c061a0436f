// SPDX-License-Identifier: MIT
#include "runtime/animation/track.h"

#include <cmath>

namespace sinew {
namespace {

bool all_finite(std::span<const float> numbers) noexcept {
  for (const float x : numbers)
    if (!std::isfinite(x)) return false;
  return true;
}

ErrorCode check_times(std::span<const float> times_s, Interpolation interpolation) noexcept {
  const std::size_t needed = interpolation == Interpolation::cubic_spline ? 2 : 1;
  if (times_s.size() < needed) return ErrorCode::too_few_keys;
  float previous = 0.0f;
  for (const float t : times_s) {
    if (!std::isfinite(t)) return ErrorCode::not_finite;
    if (t < previous) return ErrorCode::times_not_increasing;
    previous = t;
  }
  return ErrorCode::ok;
}

std::size_t values_per_key(Interpolation interpolation) noexcept {
  return interpolation == Interpolation::cubic_spline ? 3 : 1;
}

template <class V>
ErrorCode check_track(const Track<V>& track) noexcept {
  if (const ErrorCode code = check_times(track.times_s, track.interpolation); code != ErrorCode::ok) return code;
  if (track.values.size() != track.key_count() * values_per_key(track.interpolation)) return ErrorCode::size_mismatch;
  const auto* first = reinterpret_cast<const float*>(track.values.data());
  return all_finite({first, track.values.size() * V::length()}) ? ErrorCode::ok : ErrorCode::not_finite;
}

}  // namespace

ErrorCode check(const Vec3Track& track) noexcept {
  if (track.interpolation == Interpolation::squad) return ErrorCode::unsupported;
  return check_track(track);
}

ErrorCode check(const QuatTrack& track) noexcept { return check_track(track); }

ErrorCode check(const WeightTrack& track) noexcept {
  if (track.interpolation == Interpolation::squad) return ErrorCode::unsupported;
  if (const ErrorCode code = check_times(track.times_s, track.interpolation); code != ErrorCode::ok) return code;
  const std::size_t per_key = values_per_key(track.interpolation) * track.target_count;
  if (track.values.size() != track.key_count() * per_key) return ErrorCode::size_mismatch;
  return all_finite(track.values) ? ErrorCode::ok : ErrorCode::not_finite;
}

}  // namespace sinew
