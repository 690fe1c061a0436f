// SPDX-License-Identifier: MIT
#include "runtime/animation/track.h"

#include "runtime/base/all_finite.h"
#include "runtime/math/quaternion.h"

namespace sinew {
namespace {

ErrorCode check_times(std::span<const float> times_s, Interpolation interpolation) noexcept {
  const std::size_t needed = interpolation == Interpolation::cubic_spline ? 2 : 1;
  if (times_s.size() < needed) return ErrorCode::too_few_keys;
  if (!all_finite(times_s)) return ErrorCode::not_finite;
  float previous = 0.0f;
  for (const float t : times_s) {
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
  return all_finite(std::span<const V>(track.values)) ? ErrorCode::ok : ErrorCode::not_finite;
}

/// True if the quaternions of all keys have the length that their interpolation needs.
bool have_length(const QuatTrack& track) noexcept {
  bool good = true;
  if (track.interpolation == Interpolation::cubic_spline)
    for (std::size_t i = 1; i < track.values.size(); i += 3) good &= is_safe_square(square_of(track.values[i]));
  else
    for (const glm::quat& key : track.values) good &= is_unit(key);
  return good;
}

}  // namespace

ErrorCode check(const Vec3Track& track) noexcept {
  if (track.interpolation > Interpolation::cubic_spline) return ErrorCode::unsupported;
  return check_track(track);
}

ErrorCode check(const QuatTrack& track) noexcept {
  if (track.interpolation > Interpolation::squad) return ErrorCode::unsupported;
  if (const ErrorCode code = check_track(track); code != ErrorCode::ok) return code;
  return have_length(track) ? ErrorCode::ok : ErrorCode::not_normalised;
}

ErrorCode check(const WeightTrack& track) noexcept {
  if (track.interpolation > Interpolation::cubic_spline) return ErrorCode::unsupported;
  if (const ErrorCode code = check_times(track.times_s, track.interpolation); code != ErrorCode::ok) return code;
  const std::size_t per_key = values_per_key(track.interpolation) * track.target_count;
  if (track.values.size() != track.key_count() * per_key) return ErrorCode::size_mismatch;
  return all_finite(track.values) ? ErrorCode::ok : ErrorCode::not_finite;
}

}  // namespace sinew
