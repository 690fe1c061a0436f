// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/math/conventions.h"

namespace sinew {

/// How values between two keys are made. `linear` on rotations is slerp in meaning, on the short arc (G01).
/// `cubic_spline` is glTF's Hermite form: per key an in-tangent, a value and an out-tangent, tangents per second (G03).
/// `squad` runs a spherical quadrangle through rotation keys; its control points follow from the keys.
enum class Interpolation : std::uint8_t { step, linear, cubic_spline, squad };

/// Key times and values of one animated property, as the file has them. Immutable once checked.
///
/// in   times_s[K]   seconds, finite, >= 0, never decreasing; two equal times are a jump: the later key's value holds
///                   from that time on (G13)
///      values[K]    or [3K] for cubic_spline: in-tangent, value, out-tangent of key 0, then of key 1, ... (G03)
/// Values are kept in the file's precision; evaluation happens in any precision (track_sample.h).
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

/// All morph weights of one mesh instance share times: frame-major values, `target_count` per key (G19). For
/// cubic_spline a key holds all in-tangents, then all values, then all out-tangents.
struct WeightTrack {
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times_s;
  std::vector<float> values;
  std::uint32_t target_count = 0;

  bool empty() const noexcept { return times_s.empty(); }
  std::size_t key_count() const noexcept { return times_s.size(); }
};

/// err  too_few_keys, size_mismatch, not_finite, times_not_increasing (negative or decreasing times).   cost O(K)
ErrorCode check(const Vec3Track& track) noexcept;
ErrorCode check(const QuatTrack& track) noexcept;
ErrorCode check(const WeightTrack& track) noexcept;

}  // namespace sinew
