// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/math/conventions.h"

namespace sinew {

/// How values between two keys are computed. `linear` is slerp on the short arc for rotations. `cubic_spline` is
/// glTF's Hermite form: each key has an in-tangent, a value and an out-tangent; tangents are per second. `squad` is
/// spherical quadrangle interpolation of rotations, with control points computed from the keys.
enum class Interpolation : std::uint8_t { step, linear, cubic_spline, squad };

/// Key times and values of one animated property, in the precision of the file. sample_track (track_sample.h)
/// evaluates it in float or double.
///
/// in   times_s[K]   seconds, finite, >= 0, never decreasing; at two equal times the value jumps: the later key counts
///                   from that time on
///      values[K]    or [3K] for cubic_spline: in-tangent, value, out-tangent of key 0, then of key 1, ...
template <class V>
struct Track {
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times_s;
  std::vector<V> values;

  bool empty() const noexcept { return times_s.empty(); }
  std::size_t key_count() const noexcept { return times_s.size(); }
};

using Vec3Track = Track<glm::vec3>;
using QuatTrack = Track<glm::quat>;

/// Morph weights of one mesh instance with shared key times. `values` has `target_count` numbers per key. With
/// cubic_spline a key has all in-tangents, then all values, then all out-tangents.
struct WeightTrack {
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times_s;
  std::vector<float> values;
  std::uint32_t target_count = 0;

  bool empty() const noexcept { return times_s.empty(); }
  std::size_t key_count() const noexcept { return times_s.size(); }
};

/// True if a rotation is unit within tolerance. Jobs rely on it: they never divide by its length.
inline bool is_unit(const glm::quat& q) noexcept {
  constexpr float kTolerance = 2e-4f;  // of the squared length
  return std::abs(((q.x * q.x + q.y * q.y) + (q.z * q.z + q.w * q.w)) - 1.0f) <= kTolerance;
}

/// Checks everything that interpolation and jobs rely on. Rotation keys must be unit quaternions. Only the values of
/// cubic_spline rotations may have any length from 1e-10 to 1e15, since the result of that interpolation is normalised.
/// err  too_few_keys, size_mismatch, not_finite, times_not_increasing (negative or decreasing times), not_normalised
///      (rotations), unsupported (squad for a track that has no rotations, or an unknown interpolation)
/// cost O(K)
SINEW_API ErrorCode check(const Vec3Track& track) noexcept;
SINEW_API ErrorCode check(const QuatTrack& track) noexcept;
SINEW_API ErrorCode check(const WeightTrack& track) noexcept;

}  // namespace sinew
