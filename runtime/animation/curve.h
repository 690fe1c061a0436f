// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <type_traits>

#include "runtime/animation/track.h"
#include "runtime/base/result.h"
#include "runtime/math/interpolate.h"

namespace sinew {

/// How a curve goes from a key to the next one.
enum class CurveStep : std::uint8_t {
  hold,    ///< the key's value until the next key
  linear,  ///< straight; slerp along the shorter arc for rotations
  cubic    ///< Hermite, by the tangents of both keys; rotations are normalised
};

/// A key of a curve. Each key says how the curve leaves it.
template <class V>
struct CurveKey {
  float time_s = 0.0f;
  CurveStep step = CurveStep::linear;
  V value{};
  V in_tangent{}, out_tangent{};  ///< per second; used where the curve arrives or leaves by CurveStep::cubic

  friend bool operator==(const CurveKey&, const CurveKey&) = default;
};

/// A value that an engine animates beside poses: the width of a trail, a colour, a flag, the aim of a camera.
/// V is float, glm::vec2 to glm::vec4, glm::quat (unit keys) or bool (which only holds).
/// in   keys[K]  K >= 1, times finite and never decreasing; at equal times the last key counts
template <class V>
using Curve = std::span<const CurveKey<V>>;

template <class V>
inline constexpr bool kIsRotation = std::is_same_v<V, glm::quat>;

namespace detail {

inline bool is_finite(float v) noexcept { return std::isfinite(v); }
inline bool is_finite(bool) noexcept { return true; }
template <class V>
bool is_finite(const V& v) noexcept {
  for (int c = 0; c < v.length(); ++c)
    if (!std::isfinite(v[c])) return false;
  return true;
}

/// Cubic interpolation between two keys, with tangents per second.
/// eq   h00 v0 + h10 d m0 + h01 v1 + h11 d m1 with the Hermite polynomials of u, d the interval (glTF 2.0, Appendix C)
template <class V>
V hermite(const V& v0, const V& m0, const V& v1, const V& m1, float d, float u) noexcept {
  const float u2 = u * u, u3 = u2 * u;
  return v0 * (2.0f * u3 - 3.0f * u2 + 1.0f) + m0 * (d * (u3 - 2.0f * u2 + u)) + v1 * (3.0f * u2 - 2.0f * u3) +
         m1 * (d * (u3 - u2));
}

}  // namespace detail

/// Checks the keys of a curve.
/// err  too_few_keys (none), not_finite, times_not_increasing, not_normalised (rotations), unsupported (an unknown
///      step, or a flag that does not hold)
/// cost O(K)
template <class V>
ErrorCode check(Curve<V> keys) noexcept {
  if (keys.empty()) return ErrorCode::too_few_keys;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const CurveKey<V>& key = keys[k];
    if (key.step > CurveStep::cubic || (std::is_same_v<V, bool> && key.step != CurveStep::hold))
      return ErrorCode::unsupported;
    if (!std::isfinite(key.time_s) || !detail::is_finite(key.value) || !detail::is_finite(key.in_tangent) ||
        !detail::is_finite(key.out_tangent))
      return ErrorCode::not_finite;
    if (k > 0 && key.time_s < keys[k - 1].time_s) return ErrorCode::times_not_increasing;
    if constexpr (kIsRotation<V>)
      if (!is_unit(key.value)) return ErrorCode::not_normalised;
  }
  return ErrorCode::ok;
}

/// The value at a time. Before the first key it is the value of that key, and after the last key the value of the last.
/// NaN gives the first.
/// in   keys  that check() accepts      cost O(log K), no allocation
template <class V>
V sample(Curve<V> keys, double time_s) noexcept {
  const auto later = [](double time, const CurveKey<V>& key) { return time < static_cast<double>(key.time_s); };
  if (!(time_s >= static_cast<double>(keys.front().time_s))) return keys.front().value;
  const auto next = std::upper_bound(keys.begin(), keys.end(), time_s, later);
  const CurveKey<V>& a = *std::prev(next);
  if (next == keys.end() || a.step == CurveStep::hold) return a.value;
  if constexpr (!std::is_same_v<V, bool>) {
    const CurveKey<V>& b = *next;
    // In double: float would lose digits late in a long curve.
    const double interval = static_cast<double>(b.time_s) - static_cast<double>(a.time_s);
    const auto u = static_cast<float>((time_s - static_cast<double>(a.time_s)) / interval);
    if (u == 0.0f) return a.value;
    if (a.step == CurveStep::linear) {
      if constexpr (kIsRotation<V>)
        return slerp_short_arc(a.value, b.value, u);
      else
        return a.value * (1.0f - u) + b.value * u;
    }
    const V value = detail::hermite(a.value, a.out_tangent, b.value, b.in_tangent, static_cast<float>(interval), u);
    if constexpr (kIsRotation<V>)
      return normalised(value);
    else
      return value;
  }
  return a.value;
}

}  // namespace sinew
