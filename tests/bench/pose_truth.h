// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "runtime/math/quaternion.h"
#include "tests/bench/clip_characters.h"

/// Largest errors of poses, compared with double precision.
namespace sinew::bench {

/// eq   4 asin(|a - b| / 2), b aligned with a: precise for small angles
inline double angle_between_rad(const glm::quat& a, const Quat<double>& b) {
  const Quat<double> q = quat_cast<double>(a), near = quat_dot(q, b) < 0 ? -b : b;
  const Quat<double> d = q - near;
  return 4.0 * std::asin(std::min(1.0, 0.5 * std::sqrt(quat_dot(d, d))));
}

/// Largest error over eleven times of the clip. `sample(time)` returns a function from a joint to its transform.
template <class Sample>
double sampling_error_rad(const Character& c, const Sample& sample) {
  double worst = 0.0;
  for (int i = 0; i <= 10; ++i) {
    // This time is exact in float, because the plain version samples in float.
    const double time_s = static_cast<double>(static_cast<float>(c.animation.duration_s * (0.07 + 0.083 * i)));
    const auto joint = sample(time_s);
    for (const BoneAnimation& bone : c.animation.bones)
      if (!bone.rotation.empty())
        worst =
            std::max(worst, angle_between_rad(joint(bone.joint).rotation, bone.interpolate<double>(time_s).rotation));
  }
  return worst;
}

/// eq   normalised sum of the layers' rotations of equal weight, each aligned with the first
template <class Input, class Output>
double blending_error_rad(const Character& c, std::size_t layers, const Input& input, const Output& output) {
  double worst = 0.0;
  for (std::size_t j = 0; j < c.joint_count(); ++j) {
    const Quat<double> first = quat_cast<double>(input(0, j).rotation);
    Quat<double> sum = first;
    for (std::size_t l = 1; l < layers; ++l) {
      const Quat<double> q = quat_cast<double>(input(l, j).rotation);
      sum = sum + (quat_dot(first, q) < 0 ? -q : q);
    }
    worst = std::max(worst, angle_between_rad(output(j), normalised(sum)));
  }
  return worst;
}

/// Largest distance of a joint from its true position, relative to the size of the skeleton.
template <class Local, class Position>
double model_error(const Character& c, const Local& local, const Position& position) {
  std::vector<Affined> model(c.joint_count());
  double worst = 0.0, size = 1e-9;
  for (std::size_t j = 0; j < model.size(); ++j) {
    const Transform t = local(j);
    const std::uint32_t fixed = c.skeleton.fixed_matrix_of[j];
    if (fixed != kNone)
      model[j] = affine_cast<double>(c.skeleton.fixed_matrices[fixed]);
    else
      model[j] = affine_from_transform(
          Transformd{Vec3<double>(t.translation), quat_cast<double>(t.rotation), Vec3<double>(t.scale)});
    if (c.skeleton.parents[j] != kNone) model[j] = model[c.skeleton.parents[j]] * model[j];
    const Vec3<double> at = translation_of(model[j]), d = Vec3<double>(position(j)) - at;
    worst = std::max(worst, std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z));
    size = std::max({size, std::abs(at.x), std::abs(at.y), std::abs(at.z)});
  }
  return worst / size;
}

}  // namespace sinew::bench
