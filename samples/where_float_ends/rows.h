// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "runtime/math/quaternion.h"

namespace sinew::sample {

/// The largest error of one kernel over one sweep, against double or long double.
struct Row {
  std::string part;    ///< "rotations", "poses" or "vertices"
  std::string kernel;  ///< the float kernel
  std::string sweep;   ///< the inputs, in words
  double error = 0.0;
  const char* unit = "";  ///< "rad", "m", "s"
  double ulp = 0.0;  ///< the error in float steps at the magnitude of the result (rotations: of their half angle, at 1)
  double bound = 0.0;  ///< larger errors mean that something is broken
};

using Rows = std::vector<Row>;

/// Rotation kernels of runtime/math, and the errors of common shortcuts.
void add_rotation_rows(Rows& rows);
/// Chains of joints, positions far from the origin, hours of time.
void add_pose_rows(Rows& rows);
/// Kinds of skinning, normals, morph targets.
void add_vertex_rows(Rows& rows);

/// Keeps the largest of many errors; NaN counts as infinite.
class Largest {
 public:
  void add(double error, double ulp_size) {
    if (std::isnan(error)) error = std::numeric_limits<double>::infinity();
    error_ = std::fmax(error_, error);
    ulp_ = std::fmax(ulp_, error / ulp_size);
  }
  /// Adds the angle between two rotations of any length and sign.
  template <class A, class B>
  void add_turn(const Quat<A>& found, const Quat<B>& truth) {
    const double angle = rotation_angle_between(quat_cast<double>(found), quat_cast<double>(truth));
    add(angle, 2 * 0x1p-24);
  }
  /// Adds the angle between two directions.
  void add_direction(const Vec3<double>& found, const Vec3<double>& truth) {
    const auto u = normalised_or(found, Vec3<double>(0)), v = normalised_or(truth, Vec3<double>(0));
    add(2 * std::atan2(safe_length(u - v), safe_length(u + v)), 0x1p-24);
  }
  /// Adds the distance between two places.
  void add_place(const Vec3<float>& found, const Vec3<double>& truth) {
    const double size = std::fmax(std::abs(truth.x), std::fmax(std::abs(truth.y), std::abs(truth.z)));
    const float nearest = static_cast<float>(size);
    add(safe_length(Vec3<double>(found) - truth), static_cast<double>(std::nextafter(nearest, INFINITY) - nearest));
  }
  Row row(const char* part, const char* kernel, const std::string& sweep, const char* unit, double bound) const {
    return {part, kernel, sweep, error_, unit, ulp_, bound};
  }

 private:
  double error_ = 0.0, ulp_ = 0.0;
};

/// Random inputs; the same numbers on every machine.
class Sweep {
 public:
  double in(double low, double high) { return low + (high - low) * static_cast<double>(bits_()) * 0x1p-32; }
  Vec3<double> direction() {
    for (;;) {
      const double x = in(-1, 1), y = in(-1, 1), z = in(-1, 1), square = x * x + y * y + z * z;
      if (square > 0.01 && square < 1) return Vec3<double>(x, y, z) / std::sqrt(square);
    }
  }
  /// A rotation by exactly this angle about any axis.
  Quat<double> turn(double angle_rad) {
    const Vec3<double> v = direction() * std::sin(angle_rad / 2);
    return quat_xyzw(v.x, v.y, v.z, std::cos(angle_rad / 2));
  }
  Quat<double> rotation() { return turn(in(0, 3.14159)); }

 private:
  std::mt19937 bits_{12345};
};

constexpr double kDegree = 0.017453292519943295;

/// A quaternion rounded to float and back: kernel and truth get the same input.
inline Quat<double> as_stored(const Quat<double>& q) { return quat_cast<double>(quat_cast<float>(q)); }

}  // namespace sinew::sample
