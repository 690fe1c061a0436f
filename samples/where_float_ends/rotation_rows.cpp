// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <string>

#include "importer/tool/cost/rotation/approximate_slerp.h"
#include "runtime/math/decompose.h"
#include "runtime/math/euler.h"
#include "runtime/math/interpolate.h"
#include "runtime/math/quat_log_exp.h"
#include "runtime/math/rotation_between.h"
#include "samples/where_float_ends/rows.h"

namespace sinew::sample {
namespace {

constexpr const char* kPart = "rotations";
constexpr int kCount = 2000;

std::string degrees(double angle) {
  char text[32];
  std::snprintf(text, sizeof text, "%.8g", angle);
  return std::string(text) + " degrees";
}

/// eq   sin((1 - t) a) / sin a q + sin(t a) / sin a r in long double, a from chord lengths   (Real-Time Rendering,
/// eq. 4.53)
Quat<double> true_slerp(const Quat<double>& from, const Quat<double>& to, double t) {
  using L = long double;
  const Quat<L> q = normalised(quat_cast<L>(from)), r = aligned_with(q, normalised(quat_cast<L>(to)));
  const L a = 2 * std::atan2(std::sqrt(quat_dot(q - r, q - r)), std::sqrt(quat_dot(q + r, q + r)));
  if (a < 1e-15L) return quat_cast<double>(q);
  return quat_cast<double>(q * (std::sin((1 - L(t)) * a) / std::sin(a)) + r * (std::sin(L(t) * a) / std::sin(a)));
}

/// One way to interpolate between keys that are `apart` degrees from each other.
template <class Kernel>
Row between_keys(const char* name, Kernel kernel, double apart, double bound) {
  Sweep sweep;
  Largest largest;
  for (int i = 0; i < kCount; ++i) {
    const Quat<double> q = as_stored(sweep.rotation()), r = as_stored(sweep.turn(apart * kDegree) * q);
    const double t = static_cast<double>(static_cast<float>(sweep.in(0, 1)));
    largest.add_turn(kernel(quat_cast<float>(q), quat_cast<float>(r), static_cast<float>(t)), true_slerp(q, r, t));
  }
  return largest.row(kPart, name, "keys " + degrees(apart) + " apart", "rad", bound);
}

void add_interpolation(Rows& rows) {
  const auto slerp = [](auto q, auto r, float t) { return slerp_short_arc(q, r, t); };
  const auto nlerp = [](auto q, auto r, float t) { return nlerp_short_arc(q, r, t); };
  const auto corrected = [](auto q, auto r, float t) { return cost::corrected_nlerp(q, r, t); };
  const auto polynomial = [](auto q, auto r, float t) { return cost::polynomial_slerp(q, r, t); };
  for (const double apart : {0.0001, 1.0, 90.0, 179.0, 179.999})
    rows.push_back(between_keys("slerp", slerp, apart, 4e-7));
  rows.push_back(between_keys("nlerp for slerp", nlerp, 5, 3e-6));
  rows.push_back(between_keys("nlerp for slerp", nlerp, 20, 1.8e-4));
  rows.push_back(between_keys("nlerp for slerp", nlerp, 90, 0.0162));
  rows.push_back(between_keys("nlerp for slerp", nlerp, 179, 0.142));
  rows.push_back(between_keys("corrected nlerp", corrected, 90, 7.5e-5));
  rows.push_back(between_keys("corrected nlerp", corrected, 179, 8e-4));
  rows.push_back(between_keys("polynomial slerp", polynomial, 90, 4e-7));
  rows.push_back(between_keys("polynomial slerp", polynomial, 179, 6e-7));
}

Row squad_row(double step, double bound) {
  Sweep sweep;
  Largest largest;
  for (int i = 0; i < kCount; ++i) {
    Quat<double> key[4];
    key[0] = as_stored(sweep.rotation());
    for (int k = 1; k < 4; ++k) key[k] = aligned_with(key[k - 1], as_stored(sweep.turn(step * kDegree) * key[k - 1]));
    const double t = static_cast<double>(static_cast<float>(sweep.in(0, 1)));
    const auto curve = [&]<class T>(T at) {
      const auto k = [&](int n) { return quat_cast<T>(key[n]); };
      return squad(k(1), squad_control(k(0), k(1), k(2)), squad_control(k(1), k(2), k(3)), k(2), at);
    };
    largest.add_turn(curve(static_cast<float>(t)), curve(t));
  }
  return largest.row(kPart, "squad with its control points", "keys " + degrees(step) + " apart", "rad", bound);
}

Row log_exp_row(double angle, double bound) {
  Sweep sweep;
  Largest largest;
  for (int i = 0; i < kCount; ++i) {
    const Quat<double> q = as_stored(sweep.turn(angle * kDegree));
    largest.add_turn(quat_exp(quat_log(quat_cast<float>(q))), q);
  }
  return largest.row(kPart, "exp(log q)", "turns of " + degrees(angle), "rad", bound);
}

/// The absolute error of a function that measures the angle between two rotations.
template <class Measure>
Row angle_row(const char* name, Measure measure, double angle, double bound) {
  Sweep sweep;
  Largest largest;
  for (int i = 0; i < kCount; ++i) {
    const Quat<double> q = as_stored(sweep.rotation()), r = as_stored(sweep.turn(angle * kDegree) * q);
    largest.add(
        std::abs(static_cast<double>(measure(quat_cast<float>(q), quat_cast<float>(r))) - rotation_angle_between(q, r)),
        2 * 0x1p-24);
  }
  return largest.row(kPart, name, "turns of " + degrees(angle), "rad", bound);
}

Row rotation_between_row(double angle, double bound) {
  Sweep sweep;
  Largest largest;
  for (int i = 0; i < kCount; ++i) {
    const Vec3<float> s(sweep.direction()), t(rotate_vector(sweep.turn(angle * kDegree), Vec3<double>(s)));
    // If s and t are opposite, the axis is arbitrary: only check that s is rotated to t.
    const Quat<double> q = quat_cast<double>(rotation_between(s, t));
    largest.add_direction(rotate_vector(q, Vec3<double>(s)), Vec3<double>(t));
  }
  return largest.row(kPart, "rotation from one vector to another", "up to " + degrees(angle) + " apart", "rad", bound);
}

Row euler_row(double pitch, double bound) {
  Sweep sweep;
  Largest largest;
  for (int i = 0; i < kCount; ++i) {
    const HeadPitchRollT<double> e{sweep.in(-3, 3), pitch * kDegree, sweep.in(-3, 3)};
    const Mat3<float> m(matrix_from_head_pitch_roll(e));
    const auto f = head_pitch_roll_from_matrix(m);
    const auto rebuilt = matrix_from_head_pitch_roll(HeadPitchRollT<double>{f.head_rad, f.pitch_rad, f.roll_rad});
    double worst = 0;
    for (int c = 0; c < 3; ++c) worst = std::max(worst, safe_length(rebuilt[c] - Vec3<double>(m[c])));
    largest.add(worst, 0x1p-24);
  }
  return largest.row(kPart, "Euler angles, rebuilt", "pitch of " + degrees(pitch), "rad", bound);
}

Row matrix_row() {
  Sweep sweep;
  Largest largest;
  for (int i = 0; i < kCount; ++i) {
    const Quat<double> q = as_stored(sweep.turn(sweep.in(178, 180) * kDegree));
    largest.add_turn(quat_from_matrix(matrix_from_quat(quat_cast<float>(q))), q);
  }
  return largest.row(kPart, "matrix and back", "turns of 178 to 180 degrees", "rad", 6e-7);
}

Row decompose_row(double size, double bound) {
  Sweep sweep;
  Largest largest;
  for (int i = 0; i < kCount; ++i) {
    const Quat<double> q = sweep.rotation();
    const Vec3<double> s(size * sweep.in(0.5, 2), size * sweep.in(0.5, 2), size * sweep.in(0.5, 2));
    const Affine m = affine_cast<float>(affine_from_transform(Transformd{Vec3<double>(0), q, s}));
    largest.add_turn(decompose_trs(m).transform.rotation, q);
  }
  char text[48];
  std::snprintf(text, sizeof text, "scales around %g", size);
  return largest.row(kPart, "rotation out of a scaled matrix", text, "rad", bound);
}

}  // namespace

void add_rotation_rows(Rows& rows) {
  add_interpolation(rows);
  for (const double step : {5.0, 90.0, 170.0}) rows.push_back(squad_row(step, step > 100 ? 2e-6 : 1e-6));
  for (const double angle : {1e-6, 90.0, 359.999}) rows.push_back(log_exp_row(angle, angle > 180 ? 2e-6 : 6e-7));
  const auto by_acos = [](auto q, auto r) { return 2 * std::acos(std::min(1.0f, std::abs(quat_dot(q, r)))); };
  const auto by_atan2 = [](auto q, auto r) { return rotation_angle_between(q, r); };
  for (const double angle : {0.01, 1.0}) {
    rows.push_back(angle_row("angle by acos of the dot", by_acos, angle, 1e-3));
    rows.push_back(angle_row("angle by atan2", by_atan2, angle, 3e-7));
  }
  for (const double angle : {1.0, 179.0, 179.99999}) rows.push_back(rotation_between_row(angle, 6e-7));
  for (const double pitch : {45.0, 89.99, 90.0}) rows.push_back(euler_row(pitch, 6e-7));
  rows.push_back(matrix_row());
  for (const double size : {1.0, 0.001, 1e-12}) rows.push_back(decompose_row(size, 4e-7));
}

}  // namespace sinew::sample
