// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdint>

#include "runtime/math/quaternion.h"
#include "runtime/math/transform.h"

namespace sinew::test {

/// Random numbers that are the same on every machine and library: SplitMix64 (Steele et al. 2014) from a fixed seed.
class FixedRandom {
 public:
  explicit FixedRandom(std::uint64_t seed = 1) : state_(seed * 0x9E3779B97F4A7C15ull) {}

  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15ull;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
  }

  std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(bits() % count); }
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }  ///< [0, 1)
  double in(double low, double high) { return low + (high - low) * unit(); }

  /// Standard normal, by the polar method (Marsaglia).
  double normal() {
    for (;;) {
      const double x = in(-1, 1), y = in(-1, 1), s = x * x + y * y;
      if (s > 0 && s < 1) return x * std::sqrt(-2 * std::log(s) / s);
    }
  }

  template <class T = float>
  Vec3<T> vec3(double low = -1, double high = 1) {
    const double x = in(low, high), y = in(low, high), z = in(low, high);
    return {static_cast<T>(x), static_cast<T>(y), static_cast<T>(z)};
  }

  template <class T = float>
  Vec3<T> direction() {
    const double x = normal(), y = normal(), z = normal();
    return Vec3<T>(normalised_or(Vec3<double>(x, y, z), Vec3<double>(1, 0, 0)));
  }

  /// Uniform over all rotations.
  template <class T = float>
  Quat<T> rotation() {
    const double x = normal(), y = normal(), z = normal(), w = normal();
    return quat_cast<T>(normalised(quat_xyzw(x, y, z, w)));
  }

  /// Rotation by exactly `angle_rad` about a random axis.
  template <class T = float>
  Quat<T> rotation_by(double angle_rad) {
    const Vec3<double> v = direction<double>() * std::sin(angle_rad / 2);
    return quat_cast<T>(quat_xyzw(v.x, v.y, v.z, std::cos(angle_rad / 2)));
  }

  template <class T = float>
  TransformT<T> transform(double low_scale = 0.5, double high_scale = 2) {
    TransformT<T> out;
    out.translation = vec3<T>(-2, 2);
    out.rotation = rotation<T>();
    out.scale = vec3<T>(low_scale, high_scale);
    return out;
  }

 private:
  std::uint64_t state_;
};

}  // namespace sinew::test
