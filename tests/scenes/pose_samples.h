// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdint>

#include "runtime/model/pose_samples.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {

inline glm::quat about_z(double angle_rad) {
  return quat_xyzw(0.0f, 0.0f, static_cast<float>(std::sin(angle_rad / 2)),
                   static_cast<float>(std::cos(angle_rad / 2)));
}

/// Joint 1 bends about z through four poses and drives weights 1 and 0.
inline PoseSamples hinge_samples() {
  PoseSamples out;
  out.name = "hinge";
  out.drivers = {{.joint = 1}};
  out.rotations = {about_z(0.0), about_z(0.7), about_z(1.5), about_z(2.2)};
  out.weights = {1, 0};
  out.values = {0.0f, 0.0f, 0.3f, -0.2f, 1.0f, 0.4f, 1.4f, -1.0f};
  return out;
}

inline void keep_samples(PoseSamples& samples, std::size_t count) {
  samples.rotations.resize(count * samples.drivers.size());
  samples.values.resize(count * samples.weights.size());
}

/// Random poses of `drivers` joints that lie well apart: each pose gives every driver a new rotation within 120
/// degrees.
inline PoseSamples random_samples(FixedRandom& random, std::uint32_t drivers, std::size_t count,
                                  std::uint32_t weights) {
  PoseSamples out;
  for (std::uint32_t d = 0; d < drivers; ++d)
    out.drivers.push_back(
        {d, static_cast<float>(random.in(0.5, 1.5)), static_cast<RotationMeasure>(d % 3), random.direction()});
  for (std::size_t i = 0; i < count * drivers; ++i) out.rotations.push_back(random.rotation_by(random.in(-2.1, 2.1)));
  for (std::uint32_t w = 0; w < weights; ++w) out.weights.push_back(w);
  for (std::size_t i = 0; i < count * weights; ++i) out.values.push_back(static_cast<float>(random.in(-1, 2)));
  return out;
}

}  // namespace sinew::test
