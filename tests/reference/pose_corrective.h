// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "runtime/model/pose_samples.h"

namespace sinew::reference {

/// Pose-space deformation straight from its equations, in long double, solved anew for every pose. It shares no code
/// with the runtime. Rotations are matrices, so the length and sign of a quaternion cannot matter.

using Real = long double;
using Row = std::vector<Real>;
struct Rotation {
  Real m[3][3];
};

template <class Quaternion>
Rotation rotation_of(const Quaternion& given) {
  const Real n =
      std::sqrt(Real(given.x) * given.x + Real(given.y) * given.y + Real(given.z) * given.z + Real(given.w) * given.w);
  const Real x = given.x / n, y = given.y / n, z = given.z / n, w = given.w / n;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

inline Real dot(const Row& a, const Row& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Row cross(const Row& a, const Row& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Real length(const Row& a) { return std::sqrt(dot(a, a)); }
inline Row turned(const Rotation& r, const Row& v) {
  return {dot({r.m[0][0], r.m[0][1], r.m[0][2]}, v), dot({r.m[1][0], r.m[1][1], r.m[1][2]}, v),
          dot({r.m[2][0], r.m[2][1], r.m[2][2]}, v)};
}

/// eq   A^T B
inline Rotation between(const Rotation& a, const Rotation& b) {
  Rotation out{};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      for (int k = 0; k < 3; ++k) out.m[r][c] += a.m[k][r] * b.m[k][c];
  return out;
}

/// eq   sin(angle) u = the matrix' skew part; angle = atan2(|skew|, (trace - 1) / 2)
inline Row skew_of(const Rotation& r) {
  return {(r.m[2][1] - r.m[1][2]) / 2, (r.m[0][2] - r.m[2][0]) / 2, (r.m[1][0] - r.m[0][1]) / 2};
}
inline Real angle_of(const Rotation& r) {
  return std::atan2(length(skew_of(r)), (r.m[0][0] + r.m[1][1] + r.m[2][2] - 1) / 2);
}

inline Row axis_of(const PoseDriver& driver) {
  Row a{driver.axis.x, driver.axis.y, driver.axis.z};
  const Real n = length(a);
  for (Real& x : a) x /= n;
  return a;
}

/// Twist: the signed angle about the axis that remains of a rotation once its swing is removed. The swing is the
/// shortest rotation that carries the axis to its new place.
/// eq   R = Swing(a -> R a) Twist; Rodrigues for the swing
inline Real twist_of(const Rotation& r, const Row& a) {
  const Row b = turned(r, a), v = cross(a, b);
  const Real c = dot(a, b);
  const Real k[3][3] = {{0, -v[2], v[1]}, {v[2], 0, -v[0]}, {-v[1], v[0], 0}};
  Rotation swing{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      Real square = 0;
      for (int l = 0; l < 3; ++l) square += k[i][l] * k[l][j];
      swing.m[i][j] = (i == j ? 1 : 0) + k[i][j] + square / (1 + c);
    }
  const Rotation twist = between(swing, r);
  const Row s = skew_of(twist);
  return std::atan2(dot(s, a), (twist.m[0][0] + twist.m[1][1] + twist.m[2][2] - 1) / 2);
}

inline Real distance(const PoseDriver& driver, const Rotation& a, const Rotation& b) {
  const Row axis = axis_of(driver);
  if (driver.measure == RotationMeasure::swing) {
    const Row p = turned(a, axis), q = turned(b, axis);
    return std::atan2(length(cross(p, q)), dot(p, q));
  }
  if (driver.measure == RotationMeasure::twist) {
    const Real d = twist_of(b, axis) - twist_of(a, axis);
    return std::abs(std::atan2(std::sin(d), std::cos(d)));
  }
  return angle_of(between(a, b));
}

inline Real kernel(RadialKernel kind, Real x) {
  if (kind == RadialKernel::linear) return -x;
  if (kind == RadialKernel::gaussian) return std::exp(-x * x);
  return x > 0 ? x * x * std::log(x) : 0;
}

using Pose = std::vector<Rotation>;  ///< one rotation per driver

inline Row tail_at(const PoseSamples& samples, const Pose& neutral, const Pose& pose) {
  Row out;
  if (samples.tail != PolynomialTail::none) out.push_back(1);
  if (samples.tail != PolynomialTail::affine) return out;
  for (std::size_t d = 0; d < pose.size(); ++d) {
    const PoseDriver& driver = samples.drivers[d];
    const Rotation turn = between(neutral[d], pose[d]);
    const Row axis = axis_of(driver);
    if (driver.measure == RotationMeasure::twist) {
      out.push_back(std::sin(twist_of(turn, axis)));
    } else if (driver.measure == RotationMeasure::full) {
      for (const Real x : skew_of(turn)) out.push_back(x);
    } else {  // any two directions across the axis span the same functions
      const Row side = cross(axis, std::abs(axis[0]) < 0.6L ? Row{1, 0, 0} : Row{0, 1, 0});
      out.push_back(dot(turned(turn, axis), side));
      out.push_back(dot(turned(turn, axis), cross(axis, side)));
    }
  }
  return out;
}

/// Gaussian elimination with partial pivoting.
inline Row solve(std::vector<Row> a, Row b) {
  const std::size_t n = b.size();
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c + 1; r < n; ++r)
      if (std::abs(a[r][c]) > std::abs(a[pivot][c])) pivot = r;
    std::swap(a[c], a[pivot]);
    std::swap(b[c], b[pivot]);
    for (std::size_t r = c + 1; r < n; ++r) {
      const Real f = a[r][c] / a[c][c];
      for (std::size_t k = c; k < n; ++k) a[r][k] -= f * a[c][k];
      b[r] -= f * b[c];
    }
  }
  for (std::size_t c = n; c-- > 0;) {
    for (std::size_t k = c + 1; k < n; ++k) b[c] -= a[c][k] * b[k];
    b[c] /= a[c][c];
  }
  return b;
}

/// The share of each sample at a pose: the solution x of A x = basis(pose), A symmetric, so that f = x . values.
inline Row shares_at(const PoseSamples& samples, const std::vector<Pose>& poses, const Pose& pose) {
  const std::size_t count = poses.size(), size = count + tail_at(samples, poses[0], pose).size();
  const auto basis_at = [&](const Pose& p) {
    Row out;
    for (const Pose& sample : poses) {
      Real sum = 0;
      for (std::size_t d = 0; d < p.size(); ++d)
        sum += std::pow(samples.drivers[d].weight * distance(samples.drivers[d], p[d], sample[d]), 2.0L);
      out.push_back(kernel(samples.kernel, std::sqrt(sum) / samples.radius_rad));
    }
    for (const Real t : tail_at(samples, poses[0], p)) out.push_back(t);
    return out;
  };
  std::vector<Row> a(size, Row(size, 0));
  for (std::size_t i = 0; i < count; ++i) {
    const Row basis = basis_at(poses[i]);
    for (std::size_t j = 0; j < size; ++j) a[i][j] = a[j][i] = basis[j];
  }
  for (std::size_t i = 0; i < count; ++i) a[i][i] += samples.regularisation;
  Row x = solve(a, basis_at(pose));
  x.resize(count);
  return x;
}

/// The amounts that the corrective adds to its weights at a pose of its drivers.
inline Row correct_pose(const PoseSamples& samples, const Pose& pose) {
  const std::size_t drivers = samples.drivers.size(), count = samples.rotations.size() / drivers;
  std::vector<Pose> poses(count);
  for (std::size_t i = 0; i < samples.rotations.size(); ++i)
    poses[i / drivers].push_back(rotation_of(samples.rotations[i]));
  Row shares = shares_at(samples, poses, pose);
  if (samples.partition) {
    Real sum = 0;
    for (Real& s : shares) sum += s = s < 0 ? 0 : s > 1 ? 1 : s;
    for (Real& s : shares) s *= sum >= 0.01L ? 1 / sum : sum * 1e4L;
  }
  Row out;
  for (std::size_t i = 0; i < samples.weights.size(); ++i) {
    Real value = 0, low = samples.values[i], high = low;
    for (std::size_t s = 0; s < count; ++s) {
      const Real v = samples.values[s * samples.weights.size() + i];
      value += shares[s] * v;
      low = std::min(low, v);
      high = std::max(high, v);
    }
    out.push_back(samples.clamp ? std::max(low, std::min(high, value)) : value);
  }
  return out;
}

}  // namespace sinew::reference
