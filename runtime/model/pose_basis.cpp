// SPDX-License-Identifier: MIT
#include "runtime/model/pose_basis.h"

#include <cmath>

#include "runtime/math/rotation_between.h"
#include "runtime/math/swing_twist.h"

namespace sinew {
namespace {

using Vec3d = Vec3<double>;
using Quatd = Quat<double>;

Quatd unit(const glm::quat& q) noexcept { return normalised(quat_cast<double>(q)); }

Vec3d axis_of(const PoseDriver& driver) noexcept { return normalised_or(Vec3d(driver.axis), Vec3d(0.0, 1.0, 0.0)); }

double angle_between(const PoseDriver& driver, const Vec3d& axis, const Quatd& q, const Quatd& r) noexcept {
  switch (driver.measure) {
    case RotationMeasure::swing: return swing_angle_between(q, r, axis);
    case RotationMeasure::twist: return twist_angle_between(q, r, axis);
    case RotationMeasure::full: break;
  }
  return rotation_angle_between(q, r);
}

std::size_t coordinate_count(const PoseDriver& driver) noexcept {
  return driver.measure == RotationMeasure::full ? 3 : driver.measure == RotationMeasure::swing ? 2 : 1;
}

/// Sines of the rotation from `neutral` to q. They are smooth everywhere, and equal for q and -q, whereas angles or
/// logarithms would jump at half a turn.
/// eq   full   2 w v = sin(angle) u;   swing  components of the swung axis across the axis;   twist  sin(twist)
Vec3d sines(const PoseDriver& driver, const Vec3d& axis, const Quatd& neutral, const Quatd& q) noexcept {
  const Quatd turn = quat_conjugate(neutral) * q;
  if (driver.measure == RotationMeasure::full) return Vec3d(turn.x, turn.y, turn.z) * (2.0 * turn.w);
  if (driver.measure == RotationMeasure::swing) {
    const Vec3d side = perpendicular_to(axis), swung = rotate_vector(turn, axis);
    return {glm::dot(swung, side), glm::dot(swung, glm::cross(axis, side)), 0.0};
  }
  const HalfTwistT<double> half = half_twist(turn, axis);
  const double square = half.sine * half.sine + half.cosine * half.cosine;
  return {2.0 * half.sine * half.cosine / square, 0.0, 0.0};
}

double kernel_at(RadialKernel kernel, double squared) noexcept {
  switch (kernel) {
    case RadialKernel::linear: return -std::sqrt(squared);
    case RadialKernel::gaussian: return std::exp(-squared);
    case RadialKernel::thin_plate: break;
  }
  return squared > 0.0 ? 0.5 * squared * std::log(squared) : 0.0;
}

}  // namespace

std::size_t basis_size(const PoseSamples& samples) noexcept {
  std::size_t size = samples.sample_count() + (samples.tail == PolynomialTail::none ? 0 : 1);
  if (samples.tail == PolynomialTail::affine)
    for (const PoseDriver& driver : samples.drivers) size += coordinate_count(driver);
  return size;
}

void add_driver(const PoseSamples& samples, std::size_t driver, const glm::quat& rotation,
                std::span<double> basis) noexcept {
  const PoseDriver& by = samples.drivers[driver];
  const std::size_t count = samples.sample_count(), stride = samples.drivers.size();
  const Quatd q = unit(rotation);
  const Vec3d axis = axis_of(by);
  for (std::size_t s = 0; s < count; ++s) {
    const double angle = angle_between(by, axis, q, unit(samples.rotations[s * stride + driver]));
    const double distance = static_cast<double>(by.weight) * angle;
    basis[s] += distance * distance;
  }
  if (samples.tail != PolynomialTail::affine) return;
  std::size_t at = count + 1;
  for (std::size_t d = 0; d < driver; ++d) at += coordinate_count(samples.drivers[d]);
  const Vec3d sine = sines(by, axis, unit(samples.rotations[driver]), q);
  for (std::size_t c = 0; c < coordinate_count(by); ++c) basis[at + c] = sine[static_cast<int>(c)];
}

void finish_basis(const PoseSamples& samples, std::span<double> basis) noexcept {
  const std::size_t count = samples.sample_count();
  const double radius = static_cast<double>(samples.radius_rad);
  for (std::size_t s = 0; s < count; ++s) basis[s] = kernel_at(samples.kernel, basis[s] / (radius * radius));
  if (samples.tail != PolynomialTail::none) basis[count] = 1.0;
}

}  // namespace sinew
